#include "core/passage/through.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <variant>
#include <vector>

#include "core/passage/joined.h"
#include "core/phase_plane/extremal.h"
#include "core/phase_plane/time_optimal.h"
#include "core/phase_plane/turns.h"

namespace dualarm {
namespace {

/// Speeds this close, relative, are one: rounding of energies.
constexpr double kSameSpeed = 1e-9;
/// Shares of a family this close are one; times are smooth in the share.
constexpr double kShareTolerance = 1e-12;
constexpr std::uintmax_t kMostSteps = 60;  ///< of a root in the share

/// The state of rest that braking from a moving start leads to, or from which a moving goal is run up to; nothing if
/// there is none.
std::optional<JointState> rest_beside(const System& system, JointState state, bool is_start) {
  const ArcsOrBlocked arcs = is_start ? stop_from(system, state) : run_up_to(system, state);
  const auto* found = std::get_if<std::vector<Arc>>(&arcs);
  if (found == nullptr) return std::nullopt;
  if (found->empty()) return JointState{state.position, 0.0};
  return is_start ? found->back().end : found->front().start;
}

Passing passing_with(const Traveller& traveller, double position, double velocity) {
  const JointState passed = {position, velocity};
  return {velocity, fastest_duration(*traveller.system, traveller.start, passed),
          fastest_duration(*traveller.system, passed, traveller.goal)};
}

}  // namespace

std::optional<Passing> passing_of(const Profile& motion, double position, Hurry hurry) {
  if (!motion.extent().contains(position)) return std::nullopt;
  const bool early = hurry == Hurry::kEarlyArrival;
  if (position == (early ? motion.start() : motion.goal())) {
    return early ? Passing{motion.start_state().velocity, 0.0, motion.duration()}
                 : Passing{motion.goal_state().velocity, motion.duration(), 0.0};
  }
  std::optional<Passing> passing;
  for (const Leg& leg : motion.legs()) {
    if (!Interval{std::min(leg.start, leg.goal), std::max(leg.start, leg.goal)}.contains(position)) continue;
    const double time = motion.time_at(leg, position);
    passing = {motion.velocity_at(leg, position), time, motion.duration() - time};
    if (early) break;
  }
  return passing;
}

Passing fastest_passing(const Traveller& traveller, double position, Hurry hurry) {
  if (const auto passing = passing_of(traveller.fastest, position, hurry)) return *passing;
  return passing_with(traveller, position, 0.0);
}

Through::Through(const Traveller& traveller, double position, Hurry hurry, const Passing& fastest)
    : traveller_(&traveller),
      position_(position),
      hurry_(hurry),
      direction_(1.0),
      least_(fastest),
      most_velocity_(fastest.velocity) {
  const double near = (hurry == Hurry::kEarlyArrival ? traveller.start : traveller.goal).position;
  if (position == near || !exists()) return;
  direction_ = ((position > near) == (hurry == Hurry::kEarlyArrival)) ? 1.0 : -1.0;
  const double velocity = fastest_velocity();
  if (direction_ * velocity > direction_ * least_.velocity * (1.0 + kSameSpeed)) most_velocity_ = velocity;
}

/// With full drive from the start, or such that full braking leads to the goal; 0 where that does not get there.
double Through::fastest_velocity() const {
  const System& system = *traveller_->system;
  const bool early = hurry_ == Hurry::kEarlyArrival;
  JointState from = early ? traveller_->start : traveller_->goal;
  if (direction_ * from.velocity < 0.0) {
    const auto rest = rest_beside(system, from, early);
    if (!rest) return 0.0;
    from = *rest;
  }
  const Path path = early ? Path(system, from.position, position_) : Path(system, position_, from.position);
  const double far = early ? path.length() : 0.0;
  const double energy = std::min(energy_of(from), path.energy_limit());
  const Extremal arc(path, early ? ArcKind::kAccelerate : ArcKind::kBrake, path.length() - far, energy, far);
  if (arc.exit() == Extremal::Exit::kRest) return 0.0;
  const double reached = arc.exit() == Extremal::Exit::kLimit ? path.energy_limit() : arc.energy_at(far);
  return std::clamp(path.velocity(reached), system.velocity().lower, system.velocity().upper);
}

Passing Through::through_with(double velocity) const { return passing_with(*traveller_, position_, velocity); }

/// Near the fastest motion its duration grows with the root of the speed: an overshoot of the goal begins at rest.
Passing Through::at(double share) const {
  if (share <= 0.0 || most_velocity_ == least_.velocity) return least_;
  if (share >= 1.0) return through_with(most_velocity_);
  return through_with(least_.velocity + (most_velocity_ - least_.velocity) * share * share);
}

Passing Through::within(double duration, const Budget& budget) const {
  if (least_.duration() >= duration) return least_;
  const Passing most = this->most();
  if (most.duration() <= duration) return most;
  Passing beyond = most;
  const auto excess = [&](double share) {
    const Passing passing = at(share);
    const double difference = std::min(passing.duration(), kNever) - duration;
    if (difference >= 0.0 && std::abs(passing.velocity) < std::abs(beyond.velocity)) beyond = passing;
    return difference;
  };
  std::uintmax_t steps = kMostSteps;
  boost::math::tools::toms748_solve(
      excess, 0.0, 1.0, least_.duration() - duration, std::min(most.duration(), kNever) - duration,
      [&](double low, double high) { return high - low < kShareTolerance || budget.exhausted(); }, steps);
  return beyond;
}

std::optional<Profile> Through::motion(const Passing& passing) const {
  if (passing.velocity == least_.velocity && traveller_->fastest.extent().contains(position_)) {
    return traveller_->fastest;
  }
  const System& system = *traveller_->system;
  const JointState passed = {position_, passing.velocity};
  const auto before = fastest_motion(system, traveller_->start, passed, Swings::kSkip);
  const auto after = fastest_motion(system, passed, traveller_->goal, Swings::kSkip);
  if (std::holds_alternative<Blocked>(before) || std::holds_alternative<Blocked>(after)) return std::nullopt;
  return joined(system, std::get<FastestMotion>(before).profile, std::get<FastestMotion>(after).profile);
}

}  // namespace dualarm
