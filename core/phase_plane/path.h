#pragma once

#include <cmath>
#include <vector>

#include "core/model/trajectory.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// Half the square of a state's velocity, (rad/s)2.
inline double energy_of(JointState state) { return 0.5 * state.velocity * state.velocity; }

/// A system seen along one motion: x is the distance travelled from the start, so that rising and falling motions are
/// one case. Driving is full acceleration forward, braking full acceleration backward; energy is 1/2 s_dot^2, (rad/s)2.
class Path {
 public:
  /// From `start` to `goal` (rad), which differ.
  Path(const System& system, double start, double goal)
      : system_(&system),
        start_(start),
        goal_(goal),
        length_(std::abs(goal - start)),
        direction_(goal < start ? -1.0 : 1.0) {
    const double limit = std::abs(direction_ > 0.0 ? system.velocity().upper : system.velocity().lower);
    energy_limit_ = 0.5 * limit * limit;
  }

  const System& system() const { return *system_; }
  double length() const { return length_; }

  /// How far (rad) the range goes on before the start and beyond the end.
  double room_before() const { return room(start_, -direction_); }
  double room_after() const { return room(goal_, direction_); }

  double direction() const { return direction_; }

  double position(double x) const { return x == length_ ? goal_ : start_ + direction_ * x; }
  double x(double position) const { return position == goal_ ? length_ : direction_ * (position - start_); }
  double velocity(double energy) const { return direction_ * std::sqrt(2.0 * std::max(0.0, energy)); }

  /// Energy at the velocity limit; may be infinite.
  double energy_limit() const { return energy_limit_; }

  Extreme extreme(ArcKind kind) const {
    return (kind == ArcKind::kAccelerate) == (direction_ > 0.0) ? Extreme::kHighest : Extreme::kLowest;
  }

  /// Whether driving or braking depends on the velocity.
  bool velocity_matters(ArcKind kind) const { return system_->velocity_matters(extreme(kind), direction_); }

  /// Forward acceleration at x while driving (kAccelerate) or braking (kBrake) with an energy.
  double acceleration(ArcKind kind, double x, double energy) const {
    return direction_ * system_->extreme_acceleration(extreme(kind), position(x), velocity(energy));
  }

  /// Energy gained from x to x + change while driving or braking, where velocity does not matter.
  double work(ArcKind kind, double x, double change) const {
    return system_->specific_work(extreme(kind), position(x), direction_ * change);
  }

  /// `from` and `to` with the sign changes between them of the acceleration at a constant energy, ascending.
  std::vector<double> pieces(ArcKind kind, double energy, double from, double to) const;

  /// Where between `from` and `to` the accelerations have a bend, ascending, ends excluded.
  std::vector<double> bends(double from, double to) const;

 private:
  double room(double position, double direction) const {
    return direction > 0.0 ? system_->range().upper - position : position - system_->range().lower;
  }
  void add_between(const std::vector<double>& positions, double from, double to, std::vector<double>& found) const;

  const System* system_;
  double start_;
  double goal_;
  double length_;
  double direction_;
  double energy_limit_;
};

}  // namespace dualarm
