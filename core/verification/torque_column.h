#pragma once

#include <vector>

#include "core/verification/interpolant.h"
#include "core/verification/verify.h"

namespace dualarm {

/// What the written torques are worth.
struct TorqueColumnReport {
  double max_position_error = 0.0;    ///< rad, see Verification
  std::vector<Violation> violations;  ///< kind kTorqueColumn: at most one, the worst knot
};

/// Compares the torque written at each knot with the torque that the motion of `arm` (with what it carries) needs
/// there, and bounds where a drive goes that passes through the position and velocity of every knot and applies the
/// written torque linearly in between.
///
/// The bound: let E be the largest residual torque between two knots h apart, at most M h^2 / 8 by the chord bound
/// (M >= |tau''|) plus the largest mismatch at the two knots. The departure d from the interpolant obeys
/// |I d''| <= E + |G| |d| and begins with d = d' = 0 at either knot, so that at half time
///   |d| <= E / |G| (cosh(k h / 2) - 1) = E h^2 / (8 I) (sinh(y) / y)^2,   k^2 = |G| / I,   y = k h / 4,
/// by comparison with the equation that takes the equality.
TorqueColumnReport check_torque_column(const Arm& arm, const std::vector<Knot>& knots, const Interpolant& motion);

}  // namespace dualarm
