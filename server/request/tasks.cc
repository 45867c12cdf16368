#include "server/request/tasks.h"

#include <fmt/format.h>

#include "server/request/robot.h"

namespace dualarm {
namespace {

JointState read_state(const wire::JointState& message, const Field& field) {
  return {field.number("position_rad", message.position_rad(), ranges::kAngle),
          field.number("velocity_rad_per_s", message.velocity_rad_per_s(), ranges::kVelocity)};
}

}  // namespace

ArmsTask read_task(const wire::ArmTask& message, const Field& task, const std::array<Arm, kArmCount>& arms) {
  if (!message.has_start()) task.complain_missing("start", "give position_rad");
  if (!message.has_goal()) task.complain_missing("goal", "give position_rad");
  const int arm = index_of(arms, message.arm());
  if (arm < 0 && has_names(arms)) {
    task.complain("arm", fmt::format("is {}, must be {}", quoted(message.arm()), names_of(arms)));
  }
  return {arm, {read_state(message.start(), task.child("start")), read_state(message.goal(), task.child("goal"))}};
}

std::array<Task, kArmCount> read_tasks(const TaskMessages& messages, const Field& request,
                                       const std::array<Arm, kArmCount>& arms) {
  std::array<Task, kArmCount> tasks;
  if (messages.empty()) {
    request.complain_missing("tasks", "give each arm its start and goal");
    return tasks;
  }
  if (messages.size() > ranges::kMostListed) {
    request.complain("tasks", fmt::format("has {} entries, must have one for each arm", messages.size()));
    return tasks;
  }
  std::array<bool, kArmCount> given = {};
  for (int i = 0; i < messages.size(); ++i) {
    const Field field = request.child("tasks", i);
    const auto [arm, task] = read_task(messages[i], field, arms);
    if (arm >= 0 && given[arm]) {
      field.complain("arm",
                     fmt::format("is {}, which has a task already: give each arm one", quoted(messages[i].arm())));
    } else if (arm >= 0) {
      given[arm] = true;
      tasks[arm] = task;
    }
  }
  for (int arm = 0; arm < kArmCount; ++arm) {
    if (given[arm] || arms[arm].name.empty() || index_of(arms, arms[arm].name) != arm) continue;
    request.complain("tasks", fmt::format("has none for arm {}: give its start and goal", quoted(arms[arm].name)));
  }
  return tasks;
}

}  // namespace dualarm
