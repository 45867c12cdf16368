#pragma once

#include "core/model/arm.h"
#include "server/request/field.h"
#include "server/wire.h"

namespace dualarm {

/// Positions in rad, torques in N m, velocities in rad/s. What is wrong is noted on `field`; a table of torques that
/// read_torque_table cannot use is no torque at all, {0, 0}.
Interval read_joint_range(const wire::JointRange& message, const Field& field);
TorqueLimit read_torque_limit(const wire::TorqueLimit& message, const Field& field);
Interval read_velocity_limit(const wire::VelocityLimit& message, const Field& field);

}  // namespace dualarm
