#pragma once

#include "core/model/arm.h"
#include "core/phase_plane/profile.h"
#include "core/systems/single_joint_arm.h"

namespace dualarm {

/// Plays a motion (knot period in s) and expects it to be itself and within the system's limits everywhere between the
/// knots, with knots at the ends of all arcs and not many more than it takes.
void expect_faithful(const Arm& arm, const SingleJointArm& system, const Profile& profile, double period);

}  // namespace dualarm
