#pragma once

#include <vector>

#include "core/verification/interpolant.h"
#include "core/verification/joint_torque.h"
#include "core/verification/needed_torque.h"
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
/// The bound: let E be the largest residual torque between two knots h apart, at most what the needed torque departs
/// from its chord (NeededTorque) plus the largest mismatch at the two knots. The departure d from the interpolant obeys
/// |I d'' + b d'| <= E + |G| |d| and begins with d = d' = 0 at either knot. Without friction, at half time,
///   |d| <= E / |G| (cosh(k h / 2) - 1) = E h^2 / (8 I) (sinh(y) / y)^2,   k^2 = |G| / I,   y = k h / 4,
/// by comparison with the equation that takes the equality.
///
/// With friction b >= 0, at a time s after a knot,
///   d(s) = integral over r from 0 to s of K(s - r) f(r),   |f| <= E + |G| |d|,   K(u) = (1 - exp(-b u / I)) / b,
/// and K(u) <= u / I, the kernel without friction: as kernels are positive, the same bound holds after the knot. Before
/// a knot time runs backwards and friction drives: K(u) = (exp(b u / I) - 1) / b <= u exp(b u / I) / I, for u <= h / 2
/// at most u / I c with c = exp(b h / (2 I)): the same bound with I / c for I. Where c is large, the bound from the
/// knot before over all of h instead of half (four times as much without gravity) is the better one.
/// `torque` and `needed` are those of the arm and its motion.
TorqueColumnReport check_torque_column(const Arm& arm, const std::vector<Knot>& knots, const JointTorque& torque,
                                       const NeededTorque& needed, const Interpolant& motion);

}  // namespace dualarm
