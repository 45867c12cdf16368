#pragma once

#include <functional>
#include <vector>

#include "core/phase_plane/system.h"

namespace dualarm {

/// A system seen in one direction of motion (+1 or -1): x = direction * s grows along the motion, speed is at least 0,
/// and braking is the lowest admissible acceleration along x. Refers to the system, which has to outlive it.
class OneWay {
 public:
  OneWay(const System& system, double direction);

  Interval range() const { return range_; }        ///< of x, rad
  double speed_limit() const { return limit_; }    ///< rad/s; may be infinite
  bool speed_matters() const { return matters_; }  ///< for the acceleration while braking
  double direction() const { return direction_; }

  /// Acceleration along x while braking, rad/s2.
  double braking(double x, double speed) const;

  /// Its integral at standstill from x to x + change, (rad/s)2.
  double work(double x, double change) const;

  /// `within` with the sign changes of braking at a constant speed in between, ascending.
  std::vector<double> cuts(double speed, Interval within) const;

 private:
  const System& system_;
  double direction_;
  Extreme extreme_;
  Interval range_;
  double limit_;
  bool matters_;
};

/// What ends an arc of braking that is followed backwards.
enum class ArcEnd { kRange, kSpeedLimit, kRest };

/// States with one speed for each x from `from` to `to`.
struct SpeedCurve {
  double from = 0.0;                    ///< rad
  double to = 0.0;                      ///< rad
  std::function<double(double)> speed;  ///< rad/s at x (rad) in [from, to]
};

struct BrakingArc {
  SpeedCurve curve;
  ArcEnd end = ArcEnd::kRange;  ///< what its lower end, curve.from, is
};

/// The arc of full braking that passes (or, at speed 0, ends in) a state, followed backwards until the range's lower
/// end, the speed limit or rest: by work and energy where the speed does not matter, else integrated to 1e-11. At rest
/// it needs a neighbourhood below x in which braking is negative, and may end in a standstill that it approaches for
/// ever. Refers to `way`. Theory, section 1.1.
BrakingArc braking_arc_before(const OneWay& way, double x, double speed);

}  // namespace dualarm
