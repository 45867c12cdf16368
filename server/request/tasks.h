#pragma once

#include <array>

#include "core/model/problem.h"
#include "server/request/field.h"
#include "server/wire.h"

namespace dualarm {

using TaskMessages = google::protobuf::RepeatedPtrField<wire::ArmTask>;

/// One task for each arm, in the order of the arms. What is wrong is noted on `request`, which has the field `tasks`.
/// Positions outside the joint range are no violation: the planner answers them with evidence.
std::array<Task, kArmCount> read_tasks(const TaskMessages& messages, const Field& request,
                                       const std::array<Arm, kArmCount>& arms);

}  // namespace dualarm
