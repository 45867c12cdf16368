#pragma once

#include "core/model/torque_limit.h"
#include "core/phase_plane/system.h"
#include "core/systems/piecewise_linear.h"

namespace dualarm {

/// An end of a torque limit (N m).
inline double torque_end(Extreme extreme, const Interval& limits) {
  return extreme == Extreme::kLowest ? limits.lower : limits.upper;
}

/// The end of the limits that drives a motion in a direction (+1 or -1).
inline Extreme driving_extreme(double direction) { return direction > 0.0 ? Extreme::kHighest : Extreme::kLowest; }

/// An end of the limits (N m) over positions at one velocity (rad/s, may be infinite). Right in `within` only.
PiecewiseLinear torque_at_velocity(const TorqueLimit& limit, Extreme extreme, double velocity, Interval within);

/// Whether an end of the limits depends on the velocity while the joint moves in a direction, at some position.
bool torque_depends_on_velocity(const TorqueLimit& limit, Extreme extreme, double direction);

/// Whether moving in a direction leaves nowhere more driving torque, less viscous friction (N m s), than standing
/// still.
bool torque_drives_best_at_rest(const TorqueLimit& limit, double friction, double direction);

}  // namespace dualarm
