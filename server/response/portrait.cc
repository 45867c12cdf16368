#include "server/response/portrait.h"

#include "server/response/infeasible.h"
#include "server/response/motion.h"
#include "server/response/undecided.h"

namespace dualarm {
namespace {

void add_curve(wire::GetPhasePortraitResponse& message, wire::PhaseCurveKind kind,
               const std::vector<JointState>& states, const std::vector<double>& times = {}) {
  if (states.empty()) return;
  wire::PhaseCurve& curve = *message.add_curves();
  curve.set_kind(kind);
  curve.mutable_position_rad()->Reserve(static_cast<int>(states.size()));
  curve.mutable_velocity_rad_per_s()->Reserve(static_cast<int>(states.size()));
  for (const JointState& state : states) {
    curve.add_position_rad(state.position);
    curve.add_velocity_rad_per_s(state.velocity);
  }
  curve.mutable_time_s()->Add(times.begin(), times.end());
}

void add_motion(wire::GetPhasePortraitResponse& message, const DrawnMotion& motion) {
  add_curve(message, wire::PHASE_CURVE_KIND_FASTEST_MOTION, motion.states, motion.times);
  for (const Arc& arc : motion.arcs) *message.add_arcs() = arc_message(arc);
  message.set_duration_s(motion.duration);
  message.set_lower_bound_s(motion.lower_bound);
  message.set_claim(claim_message(motion.claim));
}

}  // namespace

wire::GetPhasePortraitResponse portrait_message(const ArmPortrait& portrait) {
  wire::GetPhasePortraitResponse message;
  add_curve(message, wire::PHASE_CURVE_KIND_UPPER_LIMIT, portrait.curves.upper_limit);
  add_curve(message, wire::PHASE_CURVE_KIND_LOWER_LIMIT, portrait.curves.lower_limit);
  add_curve(message, wire::PHASE_CURVE_KIND_SWITCHING, portrait.curves.rising_switch);
  add_curve(message, wire::PHASE_CURVE_KIND_SWITCHING, portrait.curves.falling_switch);
  if (const auto* motion = std::get_if<DrawnMotion>(&portrait.motion)) add_motion(message, *motion);
  if (const auto* infeasible = std::get_if<Infeasible>(&portrait.motion)) {
    *message.mutable_infeasible() = infeasible_message(*infeasible);
  }
  if (const auto* undecided = std::get_if<Undecided>(&portrait.motion)) {
    *message.mutable_undecided() = undecided_message(*undecided);
  }
  return message;
}

}  // namespace dualarm
