#pragma once

#include <vector>

#include "core/model/trajectory.h"
#include "core/phase_plane/profile.h"
#include "core/systems/single_joint_arm.h"

namespace dualarm {

/// An arm's motions as they are sent: exact arcs (holds included) and knots from 0 to `duration` (s), at most
/// `knot_period` (s) apart while the arm moves, closer where the quintic between knots would depart from the exact
/// acceleration by more than 1e-9 of the arm's acceleration scale. `motions` in order of time, not overlapping, each
/// from where the one before ended; at least one.
ArmTrajectory play(const Arm& arm, const SingleJointArm& system, const std::vector<TimedProfile>& motions,
                   double duration, double knot_period);

}  // namespace dualarm
