#pragma once

#include <vector>

#include "core/verification/interpolant.h"
#include "core/verification/joint_torque.h"
#include "core/verification/needed_torque.h"
#include "core/verification/verify.h"

namespace dualarm {

/// What an arm's motion uses of its limits, along the whole interpolant.
struct LimitReport {
  Utilisation range;
  Utilisation velocity;
  Utilisation torque;
  bool is_complete = true;            ///< false if the budget ended the check early: nothing is proven then
  std::vector<Violation> violations;  ///< kinds kJointRange, kVelocity, kTorque: at most one of each
};

/// Proven peaks of position, velocity and torque of `arm` (with what it carries) against its limits. `torque` and
/// `needed` are those of the arm and its motion.
LimitReport check_limits(const Arm& arm, const JointTorque& torque, const NeededTorque& needed,
                         const Interpolant& motion, const Budget& budget);

}  // namespace dualarm
