// GetPhasePortrait: with functions that stand in for the core's, and with the core itself.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <numbers>
#include <thread>

#include "tests/server/paper_request.h"
#include "tests/server/test_server.h"

namespace dualarm {
namespace {

using ::testing::HasSubstr;
using Code = grpc::StatusCode;

wire::GetPhasePortraitRequest portrait_request(int task = 0) {
  const wire::PlanMotionRequest plan = paper_request();
  wire::GetPhasePortraitRequest request;
  *request.mutable_robot() = plan.robot();
  *request.mutable_task() = plan.tasks(task);
  return request;
}

grpc::Status draw(const TestServer& server, const wire::GetPhasePortraitRequest& request,
                  wire::GetPhasePortraitResponse& response) {
  grpc::ClientContext context;
  return server.stub()->GetPhasePortrait(&context, request, &response);
}

PlanningFunctions core_functions() {
  PlanningFunctions functions = quick_functions();
  functions.arm_portrait = arm_portrait;
  return functions;
}

/// The core's answer.
wire::GetPhasePortraitResponse portrait_of(const wire::GetPhasePortraitRequest& request) {
  const TestServer server(core_functions());
  wire::GetPhasePortraitResponse response;
  const grpc::Status status = draw(server, request, response);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return response;
}

std::vector<wire::PhaseCurve> curves_of(const wire::GetPhasePortraitResponse& response, wire::PhaseCurveKind kind) {
  std::vector<wire::PhaseCurve> curves;
  for (const wire::PhaseCurve& curve : response.curves()) {
    EXPECT_EQ(curve.position_rad_size(), curve.velocity_rad_per_s_size());
    EXPECT_EQ(curve.time_s_size(),
              curve.kind() == wire::PHASE_CURVE_KIND_FASTEST_MOTION ? curve.position_rad_size() : 0);
    if (curve.kind() == kind) curves.push_back(curve);
  }
  return curves;
}

TEST(PhasePortrait, PutsEveryNumberOfTheCoreToItsPlace) {
  PlanningFunctions functions = quick_functions();
  functions.arm_portrait = [](const Problem& problem, int arm, int resolution, const Budget&) {
    const JointState start = problem.tasks[arm].start;
    DrawnMotion motion = {2.5,
                          1.5,
                          Claim::kOptimalMonotone,
                          {{ArcKind::kBrake, 0.0, 2.5, start, {7.0, 8.0}}},
                          {0.0, 2.5},
                          {start, {7.0, 8.0}}};
    return ArmPortrait{{{{1.0, 2.0}}, {{3.0, -4.0}}, {{5.0, 6.0}}, {{double(arm), double(-resolution)}}}, motion};
  };
  const TestServer server(functions);
  wire::GetPhasePortraitRequest request = portrait_request(1);
  request.set_resolution(77);
  wire::GetPhasePortraitResponse response;
  ASSERT_TRUE(draw(server, request, response).ok());
  ASSERT_EQ(response.curves_size(), 5);
  EXPECT_EQ(response.curves(0).kind(), wire::PHASE_CURVE_KIND_UPPER_LIMIT);
  EXPECT_EQ(response.curves(0).position_rad(0), 1.0);
  EXPECT_EQ(response.curves(0).velocity_rad_per_s(0), 2.0);
  EXPECT_EQ(response.curves(1).kind(), wire::PHASE_CURVE_KIND_LOWER_LIMIT);
  EXPECT_EQ(response.curves(1).velocity_rad_per_s(0), -4.0);
  EXPECT_EQ(response.curves(2).kind(), wire::PHASE_CURVE_KIND_SWITCHING);
  EXPECT_EQ(response.curves(2).position_rad(0), 5.0);
  EXPECT_EQ(response.curves(3).kind(), wire::PHASE_CURVE_KIND_SWITCHING);
  EXPECT_EQ(response.curves(3).position_rad(0), 1.0);
  EXPECT_EQ(response.curves(3).velocity_rad_per_s(0), -77.0);
  EXPECT_EQ(response.curves(4).kind(), wire::PHASE_CURVE_KIND_FASTEST_MOTION);
  EXPECT_EQ(response.curves(4).time_s(1), 2.5);
  EXPECT_EQ(response.curves(4).position_rad(0), request.task().start().position_rad());
  ASSERT_EQ(response.arcs_size(), 1);
  EXPECT_EQ(response.arcs(0).kind(), wire::ARC_KIND_BRAKE);
  EXPECT_EQ(response.arcs(0).end().velocity_rad_per_s(), 8.0);
  EXPECT_EQ(response.duration_s(), 2.5);
  EXPECT_EQ(response.lower_bound_s(), 1.5);
  EXPECT_EQ(response.claim(), wire::CLAIM_OPTIMAL_MONOTONE);
  EXPECT_FALSE(response.has_infeasible());
  EXPECT_FALSE(response.has_undecided());
}

TEST(PhasePortrait, IsUndecidedWhereNoMotionWasFoundAndNoneIsExcluded) {
  const TestServer server;
  wire::GetPhasePortraitResponse response;
  ASSERT_TRUE(draw(server, portrait_request(), response).ok());
  EXPECT_EQ(response.undecided().explanation(), "quick");
  EXPECT_FALSE(response.has_infeasible());
  EXPECT_FALSE(response.has_duration_s());
}

TEST(PhasePortrait, RefusesAMalformedRequestWithAllViolations) {
  const TestServer server;
  wire::GetPhasePortraitRequest request = portrait_request();
  request.mutable_task()->set_arm("nobody");
  request.set_resolution(-1);
  wire::GetPhasePortraitResponse response;
  const grpc::Status status = draw(server, request, response);
  EXPECT_EQ(status.error_code(), Code::INVALID_ARGUMENT);
  EXPECT_THAT(status.error_message(), HasSubstr("2 violations: task.arm is 'nobody', must be 'left' or 'right'"));
  EXPECT_THAT(status.error_message(), HasSubstr("resolution is -1"));
}

TEST(PhasePortrait, EndsWithTheServersCap) {
  PlanningFunctions functions = quick_functions();
  functions.arm_portrait = [](const Problem&, int, int, const Budget& budget) -> std::optional<ArmPortrait> {
    while (!budget.exhausted()) std::this_thread::yield();
    return std::nullopt;
  };
  ServerOptions options = patient_options();
  options.planning_budget = 0.05;
  const TestServer server(functions, options);
  wire::GetPhasePortraitResponse response;
  const grpc::Status status = draw(server, portrait_request(), response);
  EXPECT_EQ(status.error_code(), Code::DEADLINE_EXCEEDED);
  EXPECT_THAT(status.error_message(), HasSubstr("the phase portrait was not ready"));
}

TEST(PhasePortrait, ACallerWhoCancelsStopsTheWork) {
  std::promise<void> begun;
  std::promise<bool> cancelled;
  PlanningFunctions functions = quick_functions();
  functions.arm_portrait = [&](const Problem&, int, int, const Budget& budget) {
    begun.set_value();
    while (!budget.exhausted()) std::this_thread::yield();
    cancelled.set_value(budget.cancelled());
    return std::optional<ArmPortrait>();
  };
  const TestServer server(functions, patient_options());
  grpc::ClientContext context;
  std::future<grpc::Status> status = std::async(std::launch::async, [&] {
    wire::GetPhasePortraitResponse response;
    return server.stub()->GetPhasePortrait(&context, portrait_request(), &response);
  });
  begun.get_future().wait();
  context.TryCancel();
  EXPECT_EQ(status.get().error_code(), Code::CANCELLED);
  EXPECT_TRUE(cancelled.get_future().get());
}

TEST(PhasePortrait, OfThePapersArmIsAnAccelerationAndABrake) {
  const wire::GetPhasePortraitRequest request = portrait_request();
  const wire::GetPhasePortraitResponse response = portrait_of(request);
  EXPECT_EQ(response.claim(), wire::CLAIM_OPTIMAL);
  EXPECT_EQ(response.lower_bound_s(), response.duration_s());
  ASSERT_EQ(response.arcs_size(), 2);
  EXPECT_EQ(response.arcs(0).kind(), wire::ARC_KIND_ACCELERATE);
  EXPECT_EQ(response.arcs(1).kind(), wire::ARC_KIND_BRAKE);
  EXPECT_EQ(response.arcs(1).end_time_s(), response.duration_s());
  const auto motion = curves_of(response, wire::PHASE_CURVE_KIND_FASTEST_MOTION);
  ASSERT_EQ(motion.size(), 1u);
  EXPECT_NEAR(motion[0].time_s_size(), 361, 2);
  EXPECT_TRUE(std::is_sorted(motion[0].time_s().begin(), motion[0].time_s().end()));
  EXPECT_EQ(motion[0].position_rad(0), request.task().start().position_rad());
  EXPECT_NEAR(*motion[0].position_rad().rbegin(), request.task().goal().position_rad(), 1e-12);
  EXPECT_THAT(motion[0].time_s(), ::testing::Contains(response.arcs(1).start_time_s()));
  const auto upper = curves_of(response, wire::PHASE_CURVE_KIND_UPPER_LIMIT);
  ASSERT_EQ(upper.size(), 1u);
  EXPECT_EQ(upper[0].position_rad_size(), 361);
  EXPECT_EQ(upper[0].velocity_rad_per_s(0), 2.0);
  EXPECT_EQ(curves_of(response, wire::PHASE_CURVE_KIND_LOWER_LIMIT).size(), 1u);
  const auto switching = curves_of(response, wire::PHASE_CURVE_KIND_SWITCHING);
  ASSERT_EQ(switching.size(), 2u);
  // The switch of the motion lies on the switching curve: by work and energy, I/2 v^2 = 60 x + G (cos - cos).
  const wire::JointState& at = response.arcs(1).start();
  const double goal = request.task().goal().position_rad();
  const double work = 60.0 * (goal - at.position_rad()) + 29.43 * (std::cos(at.position_rad()) - std::cos(goal));
  EXPECT_NEAR(0.5 * 39.0 * at.velocity_rad_per_s() * at.velocity_rad_per_s(), work, 1e-9);
}

TEST(PhasePortrait, CountsWhatTheArmCarriesAndNothingElse) {
  wire::GetPhasePortraitRequest request = portrait_request();
  const double alone = portrait_of(request).duration_s();
  wire::Object& wall = *request.mutable_scene()->add_objects();
  wall.set_name("wall");
  wall.mutable_sphere()->set_radius_m(1.0);
  wall.mutable_fixed()->set_x_m(4.0);
  wall.mutable_fixed()->set_y_m(4.0);
  EXPECT_EQ(portrait_of(request).duration_s(), alone);
  wire::Object& load = *request.mutable_scene()->add_objects();
  load.set_name("load");
  load.mutable_sphere()->set_radius_m(0.1);
  load.mutable_attached()->set_arm("left");
  load.mutable_attached()->set_mass_kg(0.5);
  load.mutable_attached()->mutable_pose_in_link()->set_x_m(6.0);
  EXPECT_GT(portrait_of(request).duration_s(), 1.01 * alone);
  request.mutable_scene()->mutable_objects(1)->mutable_attached()->set_arm("right");
  EXPECT_EQ(portrait_of(request).duration_s(), alone);
}

TEST(PhasePortrait, SaysWhyThereIsNoMotionAndStillDrawsTheCurves) {
  wire::GetPhasePortraitRequest request = portrait_request();
  request.mutable_task()->mutable_goal()->set_position_rad(-0.25);
  const wire::GetPhasePortraitResponse response = portrait_of(request);
  EXPECT_EQ(response.infeasible().reason(), wire::REASON_GOAL_OUT_OF_RANGE);
  EXPECT_EQ(response.infeasible().evidence().arm(), "left");
  EXPECT_FALSE(response.has_duration_s());
  EXPECT_FALSE(response.has_lower_bound_s());
  EXPECT_EQ(response.claim(), wire::CLAIM_UNSPECIFIED);
  EXPECT_TRUE(response.arcs().empty());
  EXPECT_EQ(curves_of(response, wire::PHASE_CURVE_KIND_UPPER_LIMIT).size(), 1u);
  EXPECT_TRUE(curves_of(response, wire::PHASE_CURVE_KIND_FASTEST_MOTION).empty());
  EXPECT_TRUE(curves_of(response, wire::PHASE_CURVE_KIND_SWITCHING).empty());
}

TEST(PhasePortrait, RefusesVelocitiesThatTheLimitsDoNotAllowWithEvidence) {
  wire::GetPhasePortraitRequest fast = portrait_request();
  fast.mutable_task()->mutable_start()->set_velocity_rad_per_s(3.0);
  const wire::GetPhasePortraitResponse start = portrait_of(fast);
  EXPECT_EQ(start.infeasible().reason(), wire::REASON_START_TOO_FAST);
  EXPECT_EQ(start.infeasible().evidence().velocity_rad_per_s(), 3.0);
  fast = portrait_request();
  fast.mutable_task()->mutable_goal()->set_velocity_rad_per_s(-2.5);
  const wire::GetPhasePortraitResponse goal = portrait_of(fast);
  EXPECT_EQ(goal.infeasible().reason(), wire::REASON_GOAL_TOO_FAST);
  EXPECT_EQ(goal.infeasible().evidence().velocity_rad_per_s(), -2.5);
}

TEST(PhasePortrait, OfAnArmAtItsGoalIsOneState) {
  wire::GetPhasePortraitRequest request = portrait_request();
  *request.mutable_task()->mutable_goal() = request.task().start();
  const wire::GetPhasePortraitResponse response = portrait_of(request);
  EXPECT_TRUE(response.has_duration_s());
  EXPECT_EQ(response.duration_s(), 0.0);
  EXPECT_TRUE(response.arcs().empty());
  const auto motion = curves_of(response, wire::PHASE_CURVE_KIND_FASTEST_MOTION);
  ASSERT_EQ(motion.size(), 1u);
  EXPECT_EQ(motion[0].position_rad_size(), 1);
}

TEST(PhasePortrait, IsFiniteWithoutAVelocityLimit) {
  wire::GetPhasePortraitRequest request = portrait_request();
  auto& limit = *request.mutable_robot()->mutable_arms(0)->mutable_velocity_limit();
  limit.set_min_rad_per_s(-std::numeric_limits<double>::infinity());
  limit.set_max_rad_per_s(std::numeric_limits<double>::infinity());
  request.set_resolution(2);
  const wire::GetPhasePortraitResponse response = portrait_of(request);
  for (const wire::PhaseCurve& curve : response.curves()) {
    for (const double velocity : curve.velocity_rad_per_s()) EXPECT_TRUE(std::isfinite(velocity));
    if (curve.kind() == wire::PHASE_CURVE_KIND_FASTEST_MOTION) continue;
    EXPECT_EQ(curve.position_rad_size(), 2);
  }
}

}  // namespace
}  // namespace dualarm
