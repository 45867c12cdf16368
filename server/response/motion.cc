#include "server/response/motion.h"

#include <stdexcept>

namespace dualarm {
namespace {

wire::ArcKind arc_kind_message(ArcKind kind) {
  switch (kind) {
    case ArcKind::kAccelerate:
      return wire::ARC_KIND_ACCELERATE;
    case ArcKind::kBrake:
      return wire::ARC_KIND_BRAKE;
    case ArcKind::kCruise:
      return wire::ARC_KIND_CRUISE;
    case ArcKind::kHold:
      return wire::ARC_KIND_HOLD;
  }
  throw std::logic_error("an ArcKind without a word on the wire");
}

wire::JointState state_message(const JointState& state) {
  wire::JointState message;
  message.set_position_rad(state.position);
  message.set_velocity_rad_per_s(state.velocity);
  return message;
}

}  // namespace

wire::Arc arc_message(const Arc& arc) {
  wire::Arc message;
  message.set_kind(arc_kind_message(arc.kind));
  message.set_start_time_s(arc.start_time);
  message.set_end_time_s(arc.end_time);
  *message.mutable_start() = state_message(arc.start);
  *message.mutable_end() = state_message(arc.end);
  return message;
}

wire::Claim claim_message(Claim claim) {
  switch (claim) {
    case Claim::kOptimal:
      return wire::CLAIM_OPTIMAL;
    case Claim::kOptimalMonotone:
      return wire::CLAIM_OPTIMAL_MONOTONE;
    case Claim::kGap:
      return wire::CLAIM_GAP;
  }
  throw std::logic_error("a Claim without a word on the wire");
}

}  // namespace dualarm
