#include "server/request/arm.h"

#include <fmt/format.h>

#include <algorithm>

#include "server/request/dynamics.h"
#include "server/request/limits.h"
#include "server/request/torque_table.h"

namespace dualarm {
namespace {

Base read_base(const wire::Base& message, const Field& field) {
  Base base;
  base.position = {field.number("x_m", message.x_m(), ranges::kCoordinate),
                   field.number("y_m", message.y_m(), ranges::kCoordinate),
                   field.number("z_m", message.z_m(), ranges::kCoordinate)};
  base.heading = field.number("heading_rad", message.heading_rad(), ranges::kAngle);
  switch (message.rotation()) {
    case wire::ROTATION_UNSPECIFIED:
    case wire::ROTATION_COUNTERCLOCKWISE:
      base.rotation = Rotation::kCounterclockwise;
      break;
    case wire::ROTATION_CLOCKWISE:
      base.rotation = Rotation::kClockwise;
      break;
    default:
      field.complain("rotation", fmt::format("is {}, must be ROTATION_COUNTERCLOCKWISE or ROTATION_CLOCKWISE",
                                             static_cast<int>(message.rotation())));
  }
  return base;
}

void check_acceleration(const Arm& arm, const Field& field) {
  if (torque_bounds(arm.torque).length() <= 0.0 || arm.inertia < ranges::kTotalInertia.min) return;
  const double scale = torque_bounds(arm.torque).length() / arm.inertia;
  if (scale < ranges::kAccelerationScale.min || scale > ranges::kAccelerationScale.max) {
    field.complain(
        "torque_limit",
        fmt::format("allows accelerations over {} rad/s^2 at an inertia of {} kg m^2, must be {} to {}: check "
                    "the units of torque and inertia",
                    scale, arm.inertia, ranges::kAccelerationScale.min, ranges::kAccelerationScale.max));
  }
}

/// Friction, and the slope of a drive's line, which acts as friction does, set the shortest times of a motion.
void check_damping(const Arm& arm, const Field& field) {
  if (!(arm.inertia >= ranges::kTotalInertia.min && arm.viscous_friction >= 0.0)) return;
  const auto* line = std::get_if<TorqueSpeedLine>(&arm.torque);
  const double slope = line == nullptr || !(line->no_load_speed > 0.0) ? 0.0 : line->stall_torque / line->no_load_speed;
  const double damping = (arm.viscous_friction + slope) / arm.inertia;
  if (damping > ranges::kFastestDamping) {
    field.complain(slope > arm.viscous_friction ? "torque_limit.torque_speed.no_load_speed_rad_per_s"
                                                : "dynamics.viscous_friction_newton_meter_seconds",
                   fmt::format("dampens the arm by {} 1/s at an inertia of {} kg m^2, must be at most {} 1/s: check "
                               "the units of friction, speed and inertia",
                               damping, arm.inertia, ranges::kFastestDamping));
    return;
  }
  const Interval torque = torque_bounds(arm.torque);
  const double top_speed = std::max(-torque.lower, torque.upper) / arm.viscous_friction;
  if (torque.length() > 0.0 && top_speed < ranges::kLeastTopSpeed) {
    field.complain("dynamics.viscous_friction_newton_meter_seconds",
                   fmt::format("is {}, lets the largest torque turn the arm at {} rad/s, must be at least {} rad/s: "
                               "check the units of friction and torque",
                               arm.viscous_friction, top_speed, ranges::kLeastTopSpeed));
  }
}

}  // namespace

std::string read_name(const std::string& name, const Field& field) {
  const bool printable = std::all_of(name.begin(), name.end(), [](char c) { return c >= ' ' && c <= '~'; });
  if (name.empty()) {
    field.complain_missing("name", "give one, so that answers can tell what they are about");
  } else if (!printable || name.size() > ranges::kLongestName) {
    field.complain("name", fmt::format("is {}, must be at most {} printable ASCII characters", quoted(name),
                                       ranges::kLongestName));
  }
  return name;
}

Arm read_arm(const wire::Arm& message, const Field& field) {
  Arm arm;
  arm.name = read_name(message.name(), field);
  arm.base = read_base(message.base(), field.child("base"));
  if (message.has_link()) {
    const Field link = field.child("link");
    arm.length = link.number("length_m", message.link().length_m(), ranges::kLength);
    arm.radius = link.number("radius_m", message.link().radius_m(), ranges::kSize);
  } else {
    field.complain_missing("link", "give length_m and radius_m");
  }
  if (message.has_joint_range()) {
    arm.joint_range = read_joint_range(message.joint_range(), field.child("joint_range"));
  }
  if (message.has_dynamics()) {
    const Dynamics dynamics = read_dynamics(message.dynamics(), field.child("dynamics"), arm);
    arm.inertia = dynamics.inertia;
    arm.gravity = dynamics.gravity;
    arm.payload_gravity = dynamics.payload_gravity;
    arm.payload_gravity_phase = dynamics.payload_gravity_phase;
    arm.viscous_friction = dynamics.viscous_friction;
  } else {
    field.complain_missing("dynamics", "give mass_kg and moment_of_inertia_kg_m2");
  }
  if (message.has_torque_limit()) {
    arm.torque = read_torque_limit(message.torque_limit(), field.child("torque_limit"));
  } else {
    field.complain_missing("torque_limit", "give constant, torque_speed or table");
  }
  if (message.has_velocity_limit()) {
    arm.velocity = read_velocity_limit(message.velocity_limit(), field.child("velocity_limit"));
  } else {
    field.complain_missing("velocity_limit", "give min_rad_per_s and max_rad_per_s");
  }
  if (message.has_dynamics() && message.has_torque_limit()) {
    check_acceleration(arm, field);
    check_damping(arm, field);
    const auto* table = std::get_if<TorqueTable>(&arm.torque);
    if (table != nullptr && arm.inertia >= ranges::kTotalInertia.min) {
      check_steepness(*table, arm.inertia, field.child("torque_limit").child("table"));
    }
  }
  return arm;
}

}  // namespace dualarm
