#include "server/request/requests.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/server/request/violation_cases.h"

namespace dualarm {
namespace {

TEST(Parse, AnEmptyRequestSaysWhatIsMissing) {
  const auto found = violations_of(wire::PlanMotionRequest());
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].field, "robot");
  EXPECT_EQ(found[1].field, "tasks");
  EXPECT_EQ(violations_of(wire::VerifyMotionRequest()).size(), 1u);
  EXPECT_EQ(violations_of(wire::GetForbiddenRegionRequest()).size(), 1u);
}

TEST(Parse, ListsAllViolationsAtOnce) {
  wire::PlanMotionRequest request = paper_request();
  request.mutable_robot()->mutable_arms(0)->mutable_link()->set_length_m(kNan);
  request.mutable_robot()->mutable_arms(1)->mutable_dynamics()->set_mass_kg(-1.0);
  request.mutable_robot()->mutable_arms(1)->clear_velocity_limit();
  request.mutable_tasks(0)->mutable_start()->set_position_rad(kInfinity);
  request.mutable_options()->set_clearance_m(-1.0);
  std::map<std::string, std::string> found;
  for (const FieldViolation& violation : violations_of(request)) found[violation.field] = violation.description;
  EXPECT_EQ(found.size(), 5u);
  EXPECT_TRUE(found.contains("robot.arms[0].link.length_m"));
  EXPECT_TRUE(found.contains("robot.arms[1].dynamics.mass_kg"));
  EXPECT_TRUE(found.contains("robot.arms[1].velocity_limit"));
  EXPECT_TRUE(found.contains("tasks[0].start.position_rad"));
  EXPECT_TRUE(found.contains("options.clearance_m"));
}

TEST(Parse, CountsMoreViolationsThanItKeeps) {
  wire::PlanMotionRequest request = paper_request();
  for (int i = 0; i < 500; ++i) request.mutable_scene()->add_objects();
  const auto parsed = parse(request);
  const auto& violations = std::get<Violations>(parsed);
  EXPECT_EQ(violations.count(), 1500u);
  EXPECT_EQ(violations.kept().size(), Violations::kMostKept);
}

TEST(Parse, ChecksTheResolutionOfARegion) {
  wire::GetForbiddenRegionRequest request;
  *request.mutable_robot() = paper_request().robot();
  const auto parsed = parse(request);
  EXPECT_EQ(std::get<RegionWish>(parsed).resolution, 181);
  for (const int resolution : {-1, 1, 2001}) {
    request.set_resolution(resolution);
    const auto found = violations_of(request);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].field, "resolution");
  }
}

wire::GetPhasePortraitRequest portrait_request() {
  const wire::PlanMotionRequest plan = paper_request();
  wire::GetPhasePortraitRequest request;
  *request.mutable_robot() = plan.robot();
  *request.mutable_task() = plan.tasks(1);
  return request;
}

TEST(Parse, TakesThePortraitOfTheTasksArm) {
  wire::GetPhasePortraitRequest request = portrait_request();
  const auto parsed = parse(request);
  const auto& wish = std::get<PortraitWish>(parsed);
  EXPECT_EQ(wish.arm, 1);
  EXPECT_EQ(wish.resolution, 361);
  EXPECT_EQ(wish.problem.tasks[1].start.position, request.task().start().position_rad());
  request.set_resolution(10000);
  const auto finest = parse(request);
  EXPECT_EQ(std::get<PortraitWish>(finest).resolution, 10000);
}

TEST(Parse, NamesEachViolationOfAPortrait) {
  using Case = ViolationCase<wire::GetPhasePortraitRequest>;
  const std::vector<Case> cases = {
      {"no task", [](auto& r) { r.clear_task(); }, "task", "is missing: give the arm that is to be drawn"},
      {"no start", [](auto& r) { r.mutable_task()->clear_start(); }, "task.start", "is missing: give position_rad"},
      {"other arm", [](auto& r) { r.mutable_task()->set_arm("middle"); }, "task.arm",
       "is 'middle', must be 'left' or 'right'"},
      {"goal NaN", [](auto& r) { r.mutable_task()->mutable_goal()->set_position_rad(kNan); }, "task.goal.position_rad",
       "is nan"},
      {"one arm", [](auto& r) { r.mutable_robot()->mutable_arms()->DeleteSubrange(0, 1); }, "robot.arms",
       "has 1 entries"},
      {"one point", [](auto& r) { r.set_resolution(1); }, "resolution", "is 1, must be 2 to 10000 points"},
      {"many points", [](auto& r) { r.set_resolution(10001); }, "resolution", "is 10001"},
      {"negative", [](auto& r) { r.set_resolution(-5); }, "resolution", "is -5"},
  };
  for (const Case& expected : cases) expect_violation(portrait_request(), expected);
  EXPECT_EQ(violations_of(wire::GetPhasePortraitRequest()).size(), 2u);
}

TEST(Parse, VerifiesWithTheSameRobot) {
  wire::VerifyMotionRequest request = paper_verify_request();
  auto& line = *request.mutable_robot()->mutable_arms(0)->mutable_torque_limit()->mutable_torque_speed();
  line.set_stall_torque_newton_meters(50.0);
  line.set_no_load_speed_rad_per_s(4.0);
  request.mutable_robot()->mutable_arms(1)->mutable_dynamics()->set_viscous_friction_newton_meter_seconds(2.0);
  const auto parsed = parse(request);
  const Problem& problem = std::get<VerifyWish>(parsed).problem;
  EXPECT_EQ(std::get<TorqueSpeedLine>(problem.arms[0].torque), (TorqueSpeedLine{50.0, 4.0}));
  EXPECT_EQ(problem.arms[1].viscous_friction, 2.0);
}

}  // namespace
}  // namespace dualarm
