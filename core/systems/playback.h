#pragma once

#include <vector>

#include "core/model/trajectory.h"
#include "core/phase_plane/profile.h"
#include "core/systems/single_joint_arm.h"

namespace dualarm {

/// An arm's motions as they are sent: exact arcs (holds included) and knots from 0 to `duration` (s), at most
/// `knot_period` (s) apart while the arm moves, closer where the quintic between knots would depart from the exact
/// acceleration in the state half way by more than 1e-9 of the arm's acceleration scale. Each arc begins and ends with
/// a knot, so that the torque jumps at repeated times only.
///
/// `motions` in order of time, not overlapping, each from the state in which the one before ended; at least one.
/// Between them, before the first and after the last the arm holds, which it can do at rest only: std::logic_error if a
/// motion with a start velocity does not begin at 0 or where the one before ends, or the last one with a goal velocity
/// does not end at `duration`, to 1e-12 of the duration.
ArmTrajectory play(const Arm& arm, const SingleJointArm& system, const std::vector<TimedProfile>& motions,
                   double duration, double knot_period);

}  // namespace dualarm
