#pragma once

#include "core/model/torque_limit.h"
#include "server/request/field.h"
#include "server/wire.h"

namespace dualarm {

/// A table of torque limits. What is wrong is noted on `table`; if its columns do not fit together or are too long, or
/// a torque is out of range, the answer is no torque at all, {0, 0}.
TorqueLimit read_torque_table(const wire::TorqueTable& message, const Field& table);

/// Notes on `table` where neighbouring velocities are so close that the limits change faster with the velocity, over
/// the inertia (kg m2, > 0), than is served: such a table drives or brakes in shorter times than can be played.
void check_steepness(const TorqueTable& read, double inertia, const Field& table);

}  // namespace dualarm
