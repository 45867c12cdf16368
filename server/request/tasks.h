#pragma once

#include <array>

#include "core/model/problem.h"
#include "server/request/field.h"
#include "server/wire.h"

namespace dualarm {

using TaskMessages = google::protobuf::RepeatedPtrField<wire::ArmTask>;

/// A task and the index of its arm, -1 where the robot has none of that name.
struct ArmsTask {
  int arm = -1;
  Task task;
};

/// What is wrong is noted on `task`. States outside the joint range or the velocity limit are no violation: the planner
/// answers them with evidence.
ArmsTask read_task(const wire::ArmTask& message, const Field& task, const std::array<Arm, kArmCount>& arms);

/// One task for each arm, in the order of the arms. What is wrong is noted on `request`, which has the field `tasks`.
std::array<Task, kArmCount> read_tasks(const TaskMessages& messages, const Field& request,
                                       const std::array<Arm, kArmCount>& arms);

}  // namespace dualarm
