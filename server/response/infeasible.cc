#include "server/response/infeasible.h"

#include <stdexcept>

namespace dualarm {
namespace {

wire::Reason reason_message(InfeasibleReason reason) {
  switch (reason) {
    case InfeasibleReason::kStartInCollision:
      return wire::REASON_START_IN_COLLISION;
    case InfeasibleReason::kGoalInCollision:
      return wire::REASON_GOAL_IN_COLLISION;
    case InfeasibleReason::kStartOutsideRange:
      return wire::REASON_START_OUT_OF_RANGE;
    case InfeasibleReason::kGoalOutsideRange:
      return wire::REASON_GOAL_OUT_OF_RANGE;
    case InfeasibleReason::kStartNotHoldable:
      return wire::REASON_START_NOT_HOLDABLE;
    case InfeasibleReason::kGoalNotHoldable:
      return wire::REASON_GOAL_NOT_HOLDABLE;
    case InfeasibleReason::kTorqueTooSmall:
      return wire::REASON_TORQUE_TOO_SMALL;
    case InfeasibleReason::kStartTooFast:
      return wire::REASON_START_TOO_FAST;
    case InfeasibleReason::kGoalTooFast:
      return wire::REASON_GOAL_TOO_FAST;
    case InfeasibleReason::kVelocityLimit:
      return wire::REASON_VELOCITY_LIMIT_NOT_KEEPABLE;
    case InfeasibleReason::kObjectInSweep:
      return wire::REASON_OBJECT_IN_SWEEP;
    case InfeasibleReason::kNoCoordination:
      return wire::REASON_NO_COORDINATION;
  }
  throw std::logic_error("an InfeasibleReason without a word on the wire");
}

wire::Evidence evidence_message(const Evidence& evidence) {
  wire::Evidence message;
  message.set_arm(evidence.arm);
  if (evidence.position) message.set_position_rad(*evidence.position);
  if (evidence.velocity) message.set_velocity_rad_per_s(*evidence.velocity);
  if (evidence.needed_torque) message.set_needed_torque_newton_meters(*evidence.needed_torque);
  if (evidence.available_torque) message.set_available_torque_newton_meters(*evidence.available_torque);
  message.set_body_a(evidence.first_body);
  message.set_body_b(evidence.second_body);
  if (evidence.depth) message.set_depth_m(*evidence.depth);
  if (evidence.relaxation) message.set_relaxation(*evidence.relaxation);
  return message;
}

}  // namespace

wire::Infeasible infeasible_message(const Infeasible& infeasible) {
  wire::Infeasible message;
  message.set_reason(reason_message(infeasible.reason));
  message.set_explanation(infeasible.explanation);
  *message.mutable_evidence() = evidence_message(infeasible.evidence);
  return message;
}

}  // namespace dualarm
