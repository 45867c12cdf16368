#include "server/response/plan.h"

#include <stdexcept>

#include "server/response/motion.h"
#include "server/response/verification.h"

namespace dualarm {
namespace {

wire::Method method_message(Method method) {
  switch (method) {
    case Method::kSimultaneous:
      return wire::METHOD_SIMULTANEOUS;
    case Method::kDelay:
      return wire::METHOD_DELAY;
    case Method::kPassage:
      return wire::METHOD_PASSAGE;
    case Method::kStateTime:
      return wire::METHOD_STATE_TIME;
  }
  throw std::logic_error("a Method without a word on the wire");
}

wire::LowerBoundSource source_message(LowerBoundSource source) {
  switch (source) {
    case LowerBoundSource::kFastestMotions:
      return wire::LOWER_BOUND_SOURCE_FASTEST_MOTIONS;
    case LowerBoundSource::kPassage:
      return wire::LOWER_BOUND_SOURCE_PASSAGE;
    case LowerBoundSource::kMovingObject:
      return wire::LOWER_BOUND_SOURCE_MOVING_OBJECT;
  }
  throw std::logic_error("a LowerBoundSource without a word on the wire");
}

google::protobuf::RepeatedField<double> column_message(const std::vector<Knot>& knots, double Knot::*value) {
  google::protobuf::RepeatedField<double> column;
  column.Resize(static_cast<int>(knots.size()), 0.0);
  double* entry = column.mutable_data();
  for (const Knot& knot : knots) *entry++ = knot.*value;
  return column;
}

wire::Knots knots_message(const std::vector<Knot>& knots) {
  wire::Knots message;
  *message.mutable_time_s() = column_message(knots, &Knot::time);
  *message.mutable_position_rad() = column_message(knots, &Knot::position);
  *message.mutable_velocity_rad_per_s() = column_message(knots, &Knot::velocity);
  *message.mutable_acceleration_rad_per_s2() = column_message(knots, &Knot::acceleration);
  *message.mutable_torque_newton_meters() = column_message(knots, &Knot::torque);
  return message;
}

wire::ArmTrajectory trajectory_message(const ArmTrajectory& trajectory) {
  wire::ArmTrajectory message;
  message.set_arm(trajectory.arm);
  message.set_start_time_s(trajectory.start_time);
  message.set_duration_s(trajectory.duration);
  for (const Arc& arc : trajectory.arcs) *message.add_arcs() = arc_message(arc);
  *message.mutable_knots() = knots_message(trajectory.knots);
  return message;
}

wire::Gate gate_message(const Gate& gate, const Trajectory& trajectory) {
  wire::Gate message;
  message.set_pinned_arm(trajectory[gate.pinned_arm].arm);
  message.set_pinned_position_rad(gate.pinned_position);
  message.set_corner_position_rad(gate.corner_position);
  return message;
}

wire::ObjectVisit visit_message(const ObjectVisit& visit, const Trajectory& trajectory) {
  wire::ObjectVisit message;
  message.set_arm(trajectory[visit.arm].arm);
  message.set_object(visit.object);
  message.set_body(visit.body);
  message.set_until_s(visit.until);
  message.set_position_rad(visit.position);
  return message;
}

wire::Certificate certificate_message(const Certificate& certificate, const Trajectory& trajectory) {
  wire::Certificate message;
  message.set_lower_bound_s(certificate.lower_bound);
  message.set_gap(certificate.gap);
  message.set_claim(claim_message(certificate.claim));
  message.set_source(source_message(certificate.source));
  if (certificate.gate) *message.mutable_gate() = gate_message(*certificate.gate, trajectory);
  if (certificate.visit) *message.mutable_visit() = visit_message(*certificate.visit, trajectory);
  for (const Interval& delays : certificate.safe_start_delays.intervals()) {
    wire::Interval& interval = *message.add_safe_start_delays_s();
    interval.set_min(delays.lower);
    interval.set_max(delays.upper);
  }
  return message;
}

}  // namespace

wire::Plan plan_message(const Plan& plan) {
  wire::Plan message;
  message.set_duration_s(plan.duration);
  message.set_method(method_message(plan.method));
  for (const ArmTrajectory& trajectory : plan.trajectory) {
    *message.add_trajectories() = trajectory_message(trajectory);
  }
  *message.mutable_certificate() = certificate_message(plan.certificate, plan.trajectory);
  *message.mutable_verification() = verification_message(plan.verification);
  return message;
}

}  // namespace dualarm
