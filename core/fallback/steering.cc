#include "core/fallback/steering.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <variant>

#include "core/phase_plane/time_optimal.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// s. What is left of an arc that is cut lasts at least this: its velocities then differ by more than rounding.
constexpr double kShortestArc = 1e-6;

/// Part of a duration by which a stretched motion may miss it: what quadratures leave. Knots that are meant to share a
/// time have to (playback.h allows 1e-12).
constexpr double kSameDuration = 2e-13;

/// Where on the fastest motion, as shares of its time, a stretched one is slower.
constexpr std::array<double, 3> kSlowPlaces = {0.5, 0.25, 0.75};

/// s: in place of infinity where a root is sought.
constexpr double kNever = 1e9;

/// Looks for the share of a speed that gives a duration, as far as double precision goes; a tenth of them is usual.
constexpr std::uintmax_t kMostLooks = 100;

/// Where in [0, 1] a falling function is 0, its values at both ends given.
template <class Function>
double crossing_of_zero(const Function& function, double at_0, double at_1, const Budget& budget) {
  if (at_0 <= 0.0) return 0.0;
  if (at_1 >= 0.0) return 1.0;
  std::uintmax_t looks = kMostLooks;
  const auto is_done = [&](double left, double right) {
    return std::nextafter(left, right) >= right || budget.exhausted();
  };
  const auto [left, right] = boost::math::tools::toms748_solve(function, 0.0, 1.0, at_0, at_1, is_done, looks);
  return right;
}

}  // namespace

std::optional<Profile> steer(const System& system, JointState from, JointState to) {
  if (from == to) return Profile(system, from);
  auto motion = fastest_motion(system, from, to, Swings::kSkip);
  if (auto* fastest = std::get_if<FastestMotion>(&motion)) return std::move(fastest->profile);
  return std::nullopt;
}

double steering_time(const System& system, JointState from, JointState to) {
  return from == to ? 0.0 : fastest_duration(system, from, to);
}

std::optional<Profile> cut(const System& system, const Profile& motion, double time) {
  std::vector<Arc> arcs;
  for (const Arc& arc : motion.arcs()) {
    if (arc.end_time <= time) {
      arcs.push_back(arc);
      continue;
    }
    if (time - arc.start_time < kShortestArc || arc.end_time - time < kShortestArc) return std::nullopt;
    Arc part = arc;
    part.end = motion.at(time);
    part.end.velocity = std::clamp(part.end.velocity, system.velocity().lower, system.velocity().upper);  // to rounding
    arcs.push_back(part);
    return Profile(system, std::move(arcs));
  }
  return std::nullopt;
}

std::optional<std::vector<Profile>> stretched(const System& system, JointState from, JointState to, double duration,
                                              const Budget& budget) {
  auto fastest = steer(system, from, to);
  if (!fastest) return std::nullopt;
  const double allowed = kSameDuration * duration;
  if (std::abs(fastest->duration() - duration) <= allowed) return std::vector<Profile>{std::move(*fastest)};
  if (fastest->duration() > duration) return std::nullopt;
  for (const double place : kSlowPlaces) {
    const JointState passed = fastest->at(place * fastest->duration());
    const auto slower = [&](double share) { return JointState{passed.position, share * passed.velocity}; };
    const auto excess = [&](double share) {
      const double taken = steering_time(system, from, slower(share)) + steering_time(system, slower(share), to);
      return std::min(taken, kNever) - duration;
    };
    const double slow = excess(0.0);
    if (slow < 0.0) continue;
    const double share = crossing_of_zero(excess, slow, excess(1.0), budget);
    if (budget.exhausted()) return std::nullopt;
    auto before = steer(system, from, slower(share));
    auto after = steer(system, slower(share), to);
    if (!before || !after || std::abs(before->duration() + after->duration() - duration) > allowed) continue;
    return std::vector<Profile>{std::move(*before), std::move(*after)};
  }
  return std::nullopt;
}

double steering_time(const Systems& systems, const JointStates& from, const JointStates& to) {
  const double first = steering_time(*systems[0], from[0], to[0]);
  return std::isinf(first) ? first : std::max(first, steering_time(*systems[1], from[1], to[1]));
}

double minimum_time(const Systems& systems, const JointStates& from, const JointStates& to) {
  double bound = 0.0;
  for (int arm = 0; arm < kArmCount; ++arm) {
    const auto motion = fastest_motion(*systems[arm], from[arm], to[arm], Swings::kSkip);
    if (const auto* blocked = std::get_if<Blocked>(&motion)) {
      bound = std::max(bound, blocked->is_proven ? kInfinity : blocked->lower_bound);
    } else {
      bound = std::max(bound, std::get<FastestMotion>(motion).lower_bound);
    }
  }
  return bound;
}

double velocity_scale(const System& system) {
  constexpr double kWidest = 10.0;  // rad/s, of arms without a limit
  const Interval limits = system.velocity();
  return std::min(kWidest, std::max(-limits.lower, limits.upper));
}

bool can_hold(const System& system, JointState state) {
  return state.velocity == 0.0 && system.range().contains(state.position) &&
         system.acceleration(state.position, 0.0).contains(0.0);
}

}  // namespace dualarm
