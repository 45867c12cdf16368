#include "server/response/verification.h"

#include <stdexcept>

namespace dualarm {
namespace {

wire::ViolationKind kind_message(ViolationKind kind) {
  switch (kind) {
    case ViolationKind::kArm:
      return wire::VIOLATION_KIND_ARM;
    case ViolationKind::kKnotOrder:
      return wire::VIOLATION_KIND_KNOT_ORDER;
    case ViolationKind::kContinuity:
      return wire::VIOLATION_KIND_CONTINUITY;
    case ViolationKind::kEndState:
      return wire::VIOLATION_KIND_END_STATE;
    case ViolationKind::kJointRange:
      return wire::VIOLATION_KIND_JOINT_RANGE;
    case ViolationKind::kVelocity:
      return wire::VIOLATION_KIND_VELOCITY;
    case ViolationKind::kTorque:
      return wire::VIOLATION_KIND_TORQUE;
    case ViolationKind::kTorqueColumn:
      return wire::VIOLATION_KIND_TORQUE_COLUMN;
    case ViolationKind::kArc:
      return wire::VIOLATION_KIND_ARC;
    case ViolationKind::kClearance:
      return wire::VIOLATION_KIND_CLEARANCE;
    case ViolationKind::kClearanceUnknown:
      return wire::VIOLATION_KIND_CLEARANCE_UNKNOWN;
  }
  throw std::logic_error("a ViolationKind without a word on the wire");
}

wire::Point point_message(const Eigen::Vector3d& point) {
  wire::Point message;
  message.set_x_m(point.x());
  message.set_y_m(point.y());
  message.set_z_m(point.z());
  return message;
}

wire::ClosestApproach closest_message(const ClosestApproach& closest) {
  wire::ClosestApproach message;
  message.set_time_s(closest.time);
  message.set_body_a(closest.first_body);
  message.set_body_b(closest.second_body);
  *message.mutable_point_a() = point_message(closest.first_point);
  *message.mutable_point_b() = point_message(closest.second_point);
  return message;
}

wire::Utilisation utilisation_message(const Utilisation& utilisation) {
  wire::Utilisation message;
  message.set_value(utilisation.value);
  message.set_arm(utilisation.arm);
  message.set_time_s(utilisation.time);
  return message;
}

wire::Violation violation_message(const Violation& violation) {
  wire::Violation message;
  message.set_kind(kind_message(violation.kind));
  message.set_explanation(violation.explanation);
  message.set_arm(violation.arm);
  message.set_time_s(violation.time);
  message.set_value(violation.value);
  message.set_limit(violation.limit);
  return message;
}

}  // namespace

wire::Verification verification_message(const Verification& verification) {
  wire::Verification message;
  message.set_collision_free(verification.collision_free);
  message.set_min_clearance_m(verification.min_clearance);
  if (verification.closest) *message.mutable_closest() = closest_message(*verification.closest);
  message.set_max_position_error_rad(verification.max_position_error);
  *message.mutable_torque_utilisation() = utilisation_message(verification.torque);
  *message.mutable_velocity_utilisation() = utilisation_message(verification.velocity);
  *message.mutable_range_utilisation() = utilisation_message(verification.range);
  message.set_distance_query_count(verification.distance_query_count);
  for (const Violation& violation : verification.violations) *message.add_violations() = violation_message(violation);
  return message;
}

}  // namespace dualarm
