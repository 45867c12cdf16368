#include "server/request/limits.h"

#include <fmt/format.h>

#include "server/request/torque_table.h"

namespace dualarm {
namespace {

Interval read_constant_torque(const wire::ConstantTorque& message, const Field& field) {
  const Interval torque = {field.number("min_newton_meters", message.min_newton_meters(), ranges::kTorque),
                           field.number("max_newton_meters", message.max_newton_meters(), ranges::kTorque)};
  if (torque.lower >= torque.upper) {
    field.complain("max_newton_meters",
                   fmt::format("is {}, must exceed min_newton_meters = {}", torque.upper, torque.lower));
  }
  return torque;
}

TorqueSpeedLine read_torque_speed_line(const wire::TorqueSpeedLine& message, const Field& field) {
  return {field.number("stall_torque_newton_meters", message.stall_torque_newton_meters(), ranges::kStallTorque),
          field.number("no_load_speed_rad_per_s", message.no_load_speed_rad_per_s(), ranges::kNoLoadSpeed)};
}

}  // namespace

Interval read_joint_range(const wire::JointRange& message, const Field& field) {
  const Interval range = {field.number("min_rad", message.min_rad(), ranges::kAngle),
                          field.number("max_rad", message.max_rad(), ranges::kAngle)};
  if (range.lower >= range.upper) {
    field.complain("max_rad", fmt::format("is {}, must exceed min_rad = {}", range.upper, range.lower));
  }
  return range;
}

TorqueLimit read_torque_limit(const wire::TorqueLimit& message, const Field& field) {
  switch (message.limit_case()) {
    case wire::TorqueLimit::kConstant:
      return read_constant_torque(message.constant(), field.child("constant"));
    case wire::TorqueLimit::kTorqueSpeed:
      return read_torque_speed_line(message.torque_speed(), field.child("torque_speed"));
    case wire::TorqueLimit::kTable:
      return read_torque_table(message.table(), field.child("table"));
    case wire::TorqueLimit::LIMIT_NOT_SET:
      field.complain_missing("constant", "give min_newton_meters and max_newton_meters, or torque_speed, or table");
  }
  return {};
}

// A limit that is given as zero or not at all is the commonest slip; the range's text says what is wanted.
Interval read_velocity_limit(const wire::VelocityLimit& message, const Field& field) {
  return {field.number("min_rad_per_s", message.min_rad_per_s(), ranges::kMinVelocity),
          field.number("max_rad_per_s", message.max_rad_per_s(), ranges::kMaxVelocity)};
}

}  // namespace dualarm
