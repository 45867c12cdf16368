#pragma once

#include <optional>
#include <vector>

#include "core/model/trajectory.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// Whether two positions (rad) are one: too few digits are left between them for a motion.
bool is_one_position(double position, double other);

/// The fastest motion between two states at one position whose velocities (rad/s) are so small that the way of braking
/// them is less than positions can tell: one change of torque between the accelerations of the place, in closed form.
/// Its arcs have velocities and no length to speak of; there are none where the states are the same, or both at rest,
/// as far as positions and velocities of 1e-8 rad/s can tell. Nothing where the states are farther apart or faster than
/// that, or where the arm cannot be accelerated both ways. Theory, section 1.2.
std::optional<std::vector<Arc>> motion_on_the_spot(const System& system, JointState start, JointState goal);

}  // namespace dualarm
