#pragma once

#include <vector>

#include "core/model/arm.h"
#include "core/phase_plane/system.h"
#include "core/systems/piecewise_linear.h"

namespace dualarm {

// The surplus of a torque (N m) that is piecewise linear in the position s (rad): torque(s) - G sin(s - phi), what
// gravity leaves of it. Theory, section 1.

/// The smallest or largest surplus in `within`, N m.
double extreme_surplus(Extreme extreme, const PiecewiseLinear& torque, const GravityTorque& gravity, Interval within);

/// Where in `within` the surplus changes sign: ascending, each place once, to the last bits. Where it is zero on a
/// whole stretch between the signs, or at an end of `within`, the stretch's first position. Time is linear in the
/// turns of `within` on which torque and gravity can be equal.
/// Closed form under one torque for all positions.
std::vector<double> balances(double torque, const GravityTorque& gravity, Interval within);
std::vector<double> balances(const PiecewiseLinear& torque, const GravityTorque& gravity, Interval within);

}  // namespace dualarm
