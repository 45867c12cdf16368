#include "server/request/robot.h"

#include <fmt/format.h>

#include <algorithm>

#include "server/request/arm.h"

namespace dualarm {

std::array<Arm, kArmCount> read_robot(const wire::Robot* message, const Field& request) {
  std::array<Arm, kArmCount> arms;
  if (message == nullptr) {
    request.complain_missing("robot", "give two arms");
    return arms;
  }
  const Field robot = request.child("robot");
  if (message->arms_size() != kArmCount) {
    robot.complain("arms", fmt::format("has {} entries, must have exactly {}", message->arms_size(), kArmCount));
  }
  for (int i = 0; i < std::min(message->arms_size(), kArmCount); ++i) {
    arms[i] = read_arm(message->arms(i), robot.child("arms", i));
  }
  if (message->arms_size() >= kArmCount && !arms[0].name.empty() && arms[0].name == arms[1].name) {
    robot.child("arms", 1).complain("name", fmt::format("is {} as that of arms[0], must differ", quoted(arms[1].name)));
  }
  return arms;
}

int index_of(const std::array<Arm, kArmCount>& arms, std::string_view name) {
  for (int i = 0; i < kArmCount; ++i) {
    if (arms[i].name == name) return i;
  }
  return -1;
}

bool has_names(const std::array<Arm, kArmCount>& arms) {
  return std::any_of(arms.begin(), arms.end(), [](const Arm& arm) { return !arm.name.empty(); });
}

std::string names_of(const std::array<Arm, kArmCount>& arms) {
  if (arms[1].name.empty() || arms[1].name == arms[0].name) return quoted(arms[0].name);
  if (arms[0].name.empty()) return quoted(arms[1].name);
  return fmt::format("{} or {}", quoted(arms[0].name), quoted(arms[1].name));
}

}  // namespace dualarm
