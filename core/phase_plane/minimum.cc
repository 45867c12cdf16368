#include "core/phase_plane/minimum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/phase_plane/arc_motion.h"
#include "core/phase_plane/extremal.h"
#include "core/phase_plane/metered_system.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Accelerations and works that a proof may ask for: some milliseconds.
constexpr long kMostWork = 200'000;
/// Part by which a strict inequality of a proof has to hold beyond rounding.
constexpr double kProofMargin = 1e-9;

/// Asks at one end of a motion whether passing it faster than asked for could pay. Time is saved at most on the
/// extremal arc through that end, as if the other end could be flown past.
class RunUp {
 public:
  RunUp(const Path& path, ArcKind kind, double boundary_energy)
      : path_(path),
        kind_(kind),
        anchor_(kind == ArcKind::kAccelerate ? 0.0 : path.length()),
        far_(kind == ArcKind::kAccelerate ? path.length() : 0.0),
        energy_(boundary_energy) {}

  /// `price` (s per rad/s) of the speed at the end, which can be `fastest` (rad/s) at most. Savings and prices grow
  /// with the speed, so comparing the saving of a speed with the price of the one before holds for all in between.
  bool never_pays(const MeteredSystem& meter, double price, double fastest) const {
    if (!(fastest > 0.0)) return true;
    const double time = time_of(energy_);
    if (!std::isfinite(time) || !std::isfinite(fastest)) return false;
    for (double speed = fastest; 0.5 * speed * speed > energy_; speed /= kRatio) {
      if (meter.count() > kMostWork) return false;
      const double saved = time - time_of(0.5 * speed * speed);
      if (saved < kNothing * time) return true;
      if (!(saved < price * speed / kRatio)) return false;
    }
    return true;
  }

 private:
  /// Ratio of the speeds that are compared, and part of the duration that is not worth proving: a digit below what
  /// durations are good to.
  static constexpr double kRatio = 1.4;
  static constexpr double kNothing = 1e-10;

  /// Time over the whole path on the arc through the end with an energy, at the velocity limit where it gets there.
  double time_of(double energy) const {
    const Extremal arc(path_, kind_, anchor_, std::min(energy, path_.energy_limit()), far_);
    double time = 0.0;
    if (arc.end() != anchor_) {
      const JointState at_anchor = {path_.position(anchor_), path_.velocity(std::min(energy, path_.energy_limit()))};
      const JointState at_end = {path_.position(arc.end()), path_.velocity(arc.energy_at(arc.end()))};
      const bool forward = kind_ == ArcKind::kAccelerate;
      time = ArcMotion(path_.system(), {kind_, 0.0, 0.0, forward ? at_anchor : at_end, forward ? at_end : at_anchor})
                 .duration();
    }
    if (arc.exit() == Extremal::Exit::kRest) return kInfinity;
    const double rest = std::abs(far_ - arc.end());
    return rest > 0.0 ? time + rest / std::sqrt(2.0 * path_.energy_limit()) : time;
  }

  const Path& path_;
  ArcKind kind_;
  double anchor_;
  double far_;
  double energy_;
};

}  // namespace

Relaxation::Relaxation(const System& system, JointState start, JointState goal) : velocities_(system.velocity()) {
  const Interval at_rest = system.acceleration_bounds({0.0, 0.0});
  const bool rises_best = system.drives_best_at_rest(1.0);
  const bool falls_best = system.drives_best_at_rest(-1.0);
  Interval moving = system.acceleration_bounds();
  if (!std::isfinite(moving.length()) && rises_best && falls_best) {
    // Friction brakes without end at speeds without end: but a range is only so long.
    const double hardest = std::max(std::abs(at_rest.lower), std::abs(at_rest.upper));
    const double energy = std::max(energy_of(start), energy_of(goal)) + hardest * system.range().length();
    const double fastest = std::sqrt(2.0 * energy);
    moving = system.acceleration_bounds({std::max(velocities_.lower, -fastest), std::min(velocities_.upper, fastest)});
  }
  up_ = {rises_best ? at_rest.upper : moving.upper, -moving.lower};
  down_ = {falls_best ? -at_rest.lower : -moving.lower, moving.upper};
}

/// Along the way: braking what moves against it to rest, driving, a cruise at the limit, braking; and where the goal
/// moves against it, running up to that from rest. Infinite if that does not lead there.
double Relaxation::way_duration(double distance, double start, double goal, Drive along, Drive against, double limit) {
  double turns = 0.0;
  if (start < 0.0) {
    distance += 0.5 * start * start / against.brakes;
    turns += -start / against.brakes;
    start = 0.0;
  }
  if (goal < 0.0) {
    distance += 0.5 * goal * goal / against.drives;
    turns += -goal / against.drives;
    goal = 0.0;
  }
  const double drive_share = 0.5 / along.drives;
  const double brake_share = 0.5 / along.brakes;
  const double peak_squared =
      (distance + drive_share * start * start + brake_share * goal * goal) / (drive_share + brake_share);
  const double least_peak = std::max(start, goal);
  if (!(peak_squared >= least_peak * least_peak * (1.0 - kProofMargin))) return kInfinity;
  const double peak = std::min(std::max(std::sqrt(std::max(0.0, peak_squared)), least_peak), limit);
  const double cruise = std::max(0.0, (peak_squared - peak * peak) * (drive_share + brake_share));
  return turns + (peak - start) / along.drives + (peak - goal) / along.brakes + (cruise > 0.0 ? cruise / peak : 0.0);
}

double Relaxation::duration(JointState start, JointState goal) const {
  for (const Drive& drive : {up_, down_}) {
    if (!(drive.drives > 0.0 && std::isfinite(drive.drives) && drive.brakes > 0.0)) return 0.0;
  }
  const double distance = goal.position - start.position;
  const double upwards = way_duration(distance, start.velocity, goal.velocity, up_, down_, velocities_.upper);
  const double downwards = way_duration(-distance, -start.velocity, -goal.velocity, down_, up_, -velocities_.lower);
  const double least = std::min(upwards, downwards);
  return std::isfinite(least) ? (1.0 - kProofMargin) * least : 0.0;
}

/// Coming back with speed v takes at least a climb of v^2 / (2 U) in v / U. Before, the same distance has to be covered
/// the other way, from rest to rest, driving with at most D and braking with at most B: v sqrt((1/D + 1/B) / U).
double Relaxation::run_up_price(double direction) const {
  const Drive& there = along(-direction);
  const double drives = along(direction).drives;
  if (!(there.drives > 0.0)) return kInfinity;
  return drives > 0.0 ? 1.0 / drives + std::sqrt((1.0 / there.drives + 1.0 / there.brakes) / drives) : 0.0;
}

/// The same with time reversed: braking from v first.
double Relaxation::overshoot_price(double direction) const {
  const Drive& back = along(-direction);
  const double brakes = along(direction).brakes;
  if (!(back.drives > 0.0)) return kInfinity;
  return brakes > 0.0 ? 1.0 / brakes + std::sqrt((1.0 / back.drives + 1.0 / back.brakes) / brakes) : 0.0;
}

double Relaxation::fastest_run_up(double direction, double room) const {
  return std::min(limit(direction), std::sqrt(2.0 * std::max(0.0, along(direction).drives * room)));
}

double Relaxation::fastest_overshoot(double direction, double room) const {
  return std::min(limit(direction), std::sqrt(2.0 * std::max(0.0, along(direction).brakes * room)));
}

bool depends_on_velocity(const System& system) {
  for (const double direction : {-1.0, 1.0}) {
    if (system.velocity_matters(Extreme::kLowest, direction)) return true;
    if (system.velocity_matters(Extreme::kHighest, direction)) return true;
  }
  return false;
}

bool is_strong(const System& system) {
  const Interval range = system.range();
  const Interval at_start = system.acceleration(range.lower, 0.0);
  return at_start.lower < 0.0 && at_start.upper > 0.0 && system.zeros(Extreme::kLowest, 0.0, range).empty() &&
         system.zeros(Extreme::kHighest, 0.0, range).empty();
}

bool is_minimum_by_duration(const System& system, double duration) {
  return !depends_on_velocity(system) &&
         duration * std::sqrt(system.stiffness()) < std::numbers::pi * (1.0 - kProofMargin) && is_strong(system);
}

bool is_minimum_by_run_up(const System& system, const Profile& profile) {
  if (profile.legs().size() != 1) return false;
  const MeteredSystem meter(system);
  const Path path(meter, profile.start(), profile.goal());
  const double direction = path.direction();
  const Relaxation relaxation(system, profile.start_state(), profile.goal_state());
  return RunUp(path, ArcKind::kAccelerate, energy_of(profile.start_state()))
             .never_pays(meter, relaxation.run_up_price(direction),
                         relaxation.fastest_run_up(direction, path.room_before())) &&
         RunUp(path, ArcKind::kBrake, energy_of(profile.goal_state()))
             .never_pays(meter, relaxation.overshoot_price(direction),
                         relaxation.fastest_overshoot(direction, path.room_after()));
}

}  // namespace dualarm
