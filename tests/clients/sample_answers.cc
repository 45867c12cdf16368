#include "tests/clients/sample_answers.h"

#include <algorithm>
#include <numbers>

namespace dualarm {
namespace {

using namespace planning::v1;

void add_knot(Knots& knots, double time, double position) {
  knots.add_time_s(time);
  knots.add_position_rad(position);
  knots.add_velocity_rad_per_s(0.0);
  knots.add_acceleration_rad_per_s2(0.0);
  knots.add_torque_newton_meters(0.0);
}

void add_trajectory(Plan& plan, const std::string& arm, double start_time, double from, double to) {
  ArmTrajectory& trajectory = *plan.add_trajectories();
  trajectory.set_arm(arm);
  trajectory.set_start_time_s(start_time);
  trajectory.set_duration_s(2.0);
  Knots& knots = *trajectory.mutable_knots();
  add_knot(knots, 0.0, from);
  if (start_time > 0.0) add_knot(knots, start_time, from);
  add_knot(knots, start_time + 2.0, to);
  if (start_time + 2.0 < 3.0) add_knot(knots, 3.0, to);
}

void add_task(PlanMotionRequest& request, const std::string& arm, double from, double to) {
  request.mutable_robot()->add_arms()->set_name(arm);
  ArmTask& task = *request.add_tasks();
  task.set_arm(arm);
  task.mutable_start()->set_position_rad(from);
  task.mutable_goal()->set_position_rad(to);
}

PhaseCurve& add_curve(GetPhasePortraitResponse& response, PhaseCurveKind kind) {
  PhaseCurve& curve = *response.add_curves();
  curve.set_kind(kind);
  return curve;
}

void add_state(PhaseCurve& curve, double position, double velocity) {
  curve.add_position_rad(position);
  curve.add_velocity_rad_per_s(velocity);
}

Arc& add_arc(GetPhasePortraitResponse& response, ArcKind kind, double start_time) {
  Arc& arc = *response.add_arcs();
  arc.set_kind(kind);
  arc.set_start_time_s(start_time);
  arc.set_end_time_s(start_time + 1.0);
  return arc;
}

}  // namespace

PlanMotionRequest sample_request() {
  PlanMotionRequest request;
  add_task(request, "left", 0.5, 1.0);
  add_task(request, "<right>", 2.0, 1.0);
  return request;
}

PlanMotionResponse sample_plan() {
  PlanMotionResponse response;
  Plan& plan = *response.mutable_plan();
  plan.set_duration_s(3.0);
  plan.set_method(METHOD_DELAY);
  add_trajectory(plan, "left", 1.0, 0.5, 1.0);
  add_trajectory(plan, "<right>", 0.0, 2.0, 1.0);
  plan.mutable_certificate()->set_lower_bound_s(2.5);
  plan.mutable_certificate()->set_gap(0.2);
  plan.mutable_certificate()->set_claim(CLAIM_GAP);
  plan.mutable_verification()->set_collision_free(true);
  plan.mutable_verification()->set_min_clearance_m(0.125);
  auto& closest = *plan.mutable_verification()->mutable_closest();
  closest.set_body_a("left/link");
  closest.set_body_b("<right>/link");
  closest.set_time_s(1.5);
  response.mutable_statistics()->set_planning_time_s(0.0042);
  return response;
}

PlanMotionResponse sample_infeasible() {
  PlanMotionResponse response;
  response.mutable_infeasible()->set_reason(REASON_TORQUE_TOO_SMALL);
  response.mutable_infeasible()->set_explanation("left needs 70 N m at 90 degrees and has 60 N m");
  return response;
}

GetPhasePortraitResponse sample_portrait() {
  GetPhasePortraitResponse response;
  PhaseCurve& upper = add_curve(response, PHASE_CURVE_KIND_UPPER_LIMIT);
  for (const double position : {0.0, 0.25, 0.5, 1.0, 1.25}) add_state(upper, position, 0.8);
  PhaseCurve& lower = add_curve(response, PHASE_CURVE_KIND_LOWER_LIMIT);
  for (int k = 0; k <= 5; ++k) add_state(lower, 0.25 * k, -0.8);
  PhaseCurve& rising = add_curve(response, PHASE_CURVE_KIND_SWITCHING);
  add_state(rising, 0.5, 0.7);
  add_state(rising, 1.0, 0.0);
  PhaseCurve& falling = add_curve(response, PHASE_CURVE_KIND_SWITCHING);
  add_state(falling, 1.0, 0.0);
  add_state(falling, 1.25, -0.5);
  PhaseCurve& motion = add_curve(response, PHASE_CURVE_KIND_FASTEST_MOTION);
  for (int k = 0; k <= 40; ++k) {
    const double time = 0.05 * k;
    const double left = 2.0 - time;
    add_state(motion, time < 1.0 ? 0.5 + 0.25 * time * time : 1.0 - 0.25 * left * left, 0.5 * std::min(time, left));
    motion.add_time_s(time);
  }
  Arc& first = add_arc(response, ARC_KIND_ACCELERATE, 0.0);
  first.mutable_start()->set_position_rad(0.5);
  first.mutable_end()->set_position_rad(0.75);
  first.mutable_end()->set_velocity_rad_per_s(0.5);
  Arc& second = add_arc(response, ARC_KIND_BRAKE, 1.0);
  *second.mutable_start() = first.end();
  second.mutable_end()->set_position_rad(1.0);
  response.set_duration_s(2.0);
  response.set_lower_bound_s(2.0);
  response.set_claim(CLAIM_OPTIMAL);
  return response;
}

GetForbiddenRegionResponse sample_region() {
  GetForbiddenRegionResponse region;
  Contour& square = *region.add_contours();
  for (const auto& [theta1, theta2] : {std::pair{0.2, 0.2}, {0.4, 0.2}, {0.4, 0.4}, {0.2, 0.4}}) {
    square.add_theta1_rad(theta1);
    square.add_theta2_rad(theta2);
  }
  region.mutable_theta1_range()->set_max_rad(std::numbers::pi);
  region.mutable_theta2_range()->set_max_rad(std::numbers::pi);
  return region;
}

}  // namespace dualarm
