#include "server/request/tasks.h"

#include <gtest/gtest.h>

#include "tests/server/request/violation_cases.h"

namespace dualarm {
namespace {

TEST(ReadTasks, NamesEachViolationWithItsFieldPathAndRemedy) {
  const std::vector<PlanCase> cases = {
      {"one missing", [](auto& r) { r.mutable_tasks()->RemoveLast(); }, "tasks",
       "has none for arm 'right': give its start and goal"},
      {"doubled", [](auto& r) { *r.add_tasks() = r.tasks(0); }, "tasks[2].arm", "is 'left', which has a task already"},
      {"no start", [](auto& r) { r.mutable_tasks(1)->clear_start(); }, "tasks[1].start",
       "is missing: give position_rad"},
      {"no goal", [](auto& r) { r.mutable_tasks(0)->clear_goal(); }, "tasks[0].goal", "is missing: give position_rad"},
      {"start NaN", [](auto& r) { r.mutable_tasks(0)->mutable_start()->set_position_rad(kNan); },
       "tasks[0].start.position_rad", "is nan"},
      {"goal infinite", [](auto& r) { r.mutable_tasks(1)->mutable_goal()->set_position_rad(kInfinity); },
       "tasks[1].goal.position_rad", "is inf"},
      {"goal velocity infinite", [](auto& r) { r.mutable_tasks(0)->mutable_goal()->set_velocity_rad_per_s(kInfinity); },
       "tasks[0].goal.velocity_rad_per_s", "is inf, must be -1000000 to 1000000 rad/s"},
      {"start velocity huge", [](auto& r) { r.mutable_tasks(1)->mutable_start()->set_velocity_rad_per_s(-2e6); },
       "tasks[1].start.velocity_rad_per_s", "is -2000000, must be"},
      {"start velocity NaN", [](auto& r) { r.mutable_tasks(1)->mutable_start()->set_velocity_rad_per_s(kNan); },
       "tasks[1].start.velocity_rad_per_s", "is nan"},
      {"many",
       [](auto& r) {
         for (int i = 0; i < 20; ++i) r.add_tasks();
       },
       "tasks", "has 22 entries"},
  };
  for (const PlanCase& expected : cases) expect_violation(paper_request(), expected);
}

TEST(ReadTasks, AWrongArmLeavesTheOtherWithoutATask) {
  wire::PlanMotionRequest request = paper_request();
  request.mutable_tasks(0)->set_arm("Left");
  const auto found = violations_of(request);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].field, "tasks[0].arm");
  EXPECT_EQ(found[0].description, "is 'Left', must be 'left' or 'right'");
  EXPECT_EQ(found[1].field, "tasks");
}

TEST(ReadTasks, ProposesNamesThatAreThereAndEachOnce) {
  wire::PlanMotionRequest request = paper_request();
  request.mutable_tasks(0)->set_arm("nobody");
  wire::PlanMotionRequest equal = request;
  equal.mutable_robot()->mutable_arms(1)->set_name("left");
  wire::PlanMotionRequest first_nameless = request;
  first_nameless.mutable_robot()->mutable_arms(0)->clear_name();
  wire::PlanMotionRequest alone = request;
  alone.mutable_robot()->mutable_arms()->RemoveLast();
  const auto remedy = [](const wire::PlanMotionRequest& wrong) {
    for (const FieldViolation& violation : violations_of(wrong)) {
      if (violation.field == "tasks[0].arm") return violation.description;
    }
    return std::string();
  };
  EXPECT_EQ(remedy(equal), "is 'nobody', must be 'left'");
  EXPECT_EQ(remedy(first_nameless), "is 'nobody', must be 'right'");
  EXPECT_EQ(remedy(alone), "is 'nobody', must be 'left'");
}

TEST(ReadTasks, OrdersTasksAsTheArms) {
  wire::PlanMotionRequest request = paper_request();
  request.mutable_tasks()->SwapElements(0, 1);
  const auto parsed = parse(request);
  const auto& tasks = std::get<PlanWish>(parsed).problem.tasks;
  EXPECT_LT(tasks[0].start.position, tasks[0].goal.position);
  EXPECT_GT(tasks[1].start.position, tasks[1].goal.position);
}

TEST(ReadTasks, StatesOutsideTheLimitsAreThePlannersToAnswer) {
  wire::PlanMotionRequest request = paper_request();
  request.mutable_tasks(0)->mutable_goal()->set_position_rad(-0.5);
  request.mutable_tasks(1)->mutable_start()->set_velocity_rad_per_s(200.0);
  EXPECT_TRUE(violations_of(request).empty());
}

TEST(ReadTasks, TakesVelocitiesToTheirPlaces) {
  wire::PlanMotionRequest request = paper_request();
  request.mutable_tasks(0)->mutable_start()->set_velocity_rad_per_s(0.25);
  request.mutable_tasks(1)->mutable_goal()->set_velocity_rad_per_s(-0.5);
  const auto parsed = parse(request);
  const auto& tasks = std::get<PlanWish>(parsed).problem.tasks;
  EXPECT_EQ(tasks[0].start.velocity, 0.25);
  EXPECT_EQ(tasks[0].goal.velocity, 0.0);
  EXPECT_EQ(tasks[1].goal.velocity, -0.5);
}

}  // namespace
}  // namespace dualarm
