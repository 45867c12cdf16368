#pragma once

#include <cmath>
#include <vector>

#include "core/model/trajectory.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// A system seen along one motion: x is the distance travelled from the start, so that rising and falling motions are
/// one case. Driving is full acceleration forward, braking full acceleration backward; energy is 1/2 s_dot^2, (rad/s)2.
class Path {
 public:
  Path(const System& system, double start, double goal)
      : system_(system),
        start_(start),
        goal_(goal),
        length_(std::abs(goal - start)),
        direction_(goal < start ? -1.0 : 1.0) {}

  double length() const { return length_; }
  double goal() const { return goal_; }
  double position(double x) const { return start_ + direction_ * x; }
  double direction() const { return direction_; }

  Extreme extreme(ArcKind kind) const {
    return (kind == ArcKind::kAccelerate) == (direction_ > 0.0) ? Extreme::kHighest : Extreme::kLowest;
  }

  /// Forward acceleration at x while driving (kAccelerate) or braking (kBrake).
  double acceleration(ArcKind kind, double x) const {
    return direction_ * system_.extreme_acceleration(extreme(kind), position(x), 0.0);
  }

  /// Energy gained from x to x + change while driving or braking.
  double work(ArcKind kind, double x, double change) const {
    return system_.specific_work(extreme(kind), position(x), direction_ * change);
  }

  /// Whether driving or braking from x to x + change gains or loses energy that shows beside `energy`. Between two
  /// close zeros of an acceleration it need not, and then the arc is the velocity limit to rounding.
  bool work_shows(ArcKind kind, double x, double change, double energy) const {
    constexpr double kShowing = 1e-12;  // of the energy: some thousand roundings of it
    return std::abs(work(kind, x, change)) > kShowing * energy;
  }

  /// Energy at the velocity limit; may be infinite.
  double energy_limit() const {
    const double limit = direction_ > 0.0 ? system_.velocity().upper : system_.velocity().lower;
    return 0.5 * limit * limit;
  }

  /// `from` and `to` with the sign changes of the acceleration between them, ascending: in each piece the energy along
  /// an arc of this kind is monotone.
  std::vector<double> monotone_pieces(ArcKind kind, double from, double to) const;

 private:
  const System& system_;
  double start_;
  double goal_;
  double length_;
  double direction_;
};

}  // namespace dualarm
