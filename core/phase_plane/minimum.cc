#include "core/phase_plane/minimum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/phase_plane/arc_motion.h"
#include "core/phase_plane/extremal.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Part by which a strict inequality of a proof has to hold beyond rounding.
constexpr double kProofMargin = 1e-9;

/// Duration of driving up with `drive` and braking with `brake` (both > 0), cruising at the limit in between; infinite
/// if that does not lead there.
double way_duration(double distance, double start, double goal, double drive, double brake, double limit) {
  const double drive_share = 0.5 / drive;
  const double brake_share = 0.5 / brake;
  const double peak_squared =
      (distance + drive_share * start * start + brake_share * goal * goal) / (drive_share + brake_share);
  const double least_peak = std::max({0.0, start, goal});
  if (!(peak_squared >= least_peak * least_peak * (1.0 - kProofMargin))) return kInfinity;
  const double peak = std::min(std::max(std::sqrt(peak_squared), least_peak), limit);
  const double cruise = std::max(0.0, (peak_squared - peak * peak) * (drive_share + brake_share));
  return (peak - start) / drive + (peak - goal) / brake + (cruise > 0.0 ? cruise / peak : 0.0);
}

/// What swinging away and coming back to the same place with more speed costs at least, s per rad/s of that speed: with
/// accelerations of at most `towards` in the direction of the speed and `away` against it.
double run_up_price(double towards, double away) {
  if (!(away > 0.0)) return kInfinity;
  return std::isfinite(away) && std::isfinite(towards) ? (1.0 + std::sqrt(1.0 + towards / away)) / towards : 0.0;
}

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
  bool never_pays(double price, double fastest) const {
    if (!(fastest > 0.0)) return true;
    const double time = time_of(energy_);
    if (!std::isfinite(time) || !std::isfinite(fastest)) return false;
    for (double speed = fastest; 0.5 * speed * speed > energy_; speed /= kRatio) {
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

/// Speed with which a run-up of `room` can end at most.
double fastest_run_up(const Path& path, double acceleration, double room) {
  return std::sqrt(2.0 * std::min(path.energy_limit(), std::max(0.0, acceleration) * room));
}

}  // namespace

double Relaxation::duration(JointState start, JointState goal) const {
  const auto& [lowest, highest] = accelerations_;
  if (!(highest > 0.0 && lowest < 0.0 && std::isfinite(highest - lowest))) return 0.0;
  const double distance = goal.position - start.position;
  const double upwards = way_duration(distance, start.velocity, goal.velocity, highest, -lowest, velocities_.upper);
  const double downwards =
      way_duration(-distance, -start.velocity, -goal.velocity, -lowest, highest, -velocities_.lower);
  const double least = std::min(upwards, downwards);
  return std::isfinite(least) ? (1.0 - kProofMargin) * least : 0.0;
}

bool is_strong(const System& system) {
  const Interval range = system.range();
  const Interval at_start = system.acceleration(range.lower, 0.0);
  return at_start.lower < 0.0 && at_start.upper > 0.0 && system.zeros(Extreme::kLowest, 0.0, range).empty() &&
         system.zeros(Extreme::kHighest, 0.0, range).empty();
}

bool is_minimum_by_duration(const System& system, double duration) {
  for (const double direction : {-1.0, 1.0}) {
    if (system.velocity_matters(Extreme::kLowest, direction)) return false;
    if (system.velocity_matters(Extreme::kHighest, direction)) return false;
  }
  return duration * std::sqrt(system.stiffness()) < std::numbers::pi * (1.0 - kProofMargin) && is_strong(system);
}

bool is_minimum_by_run_up(const System& system, const Profile& profile) {
  if (profile.legs().size() != 1) return false;
  const Path path(system, profile.start(), profile.goal());
  const Interval bounds = system.acceleration_bounds();
  const Interval range = system.range();
  const bool rising = path.direction() > 0.0;
  const double forward = rising ? bounds.upper : -bounds.lower;
  const double backward = rising ? -bounds.lower : bounds.upper;
  const auto energy = [](JointState state) { return 0.5 * state.velocity * state.velocity; };
  const double room_before = rising ? profile.start() - range.lower : range.upper - profile.start();
  const double room_after = rising ? range.upper - profile.goal() : profile.goal() - range.lower;
  return RunUp(path, ArcKind::kAccelerate, energy(profile.start_state()))
             .never_pays(run_up_price(forward, backward), fastest_run_up(path, forward, room_before)) &&
         RunUp(path, ArcKind::kBrake, energy(profile.goal_state()))
             .never_pays(run_up_price(backward, forward), fastest_run_up(path, backward, room_after));
}

}  // namespace dualarm
