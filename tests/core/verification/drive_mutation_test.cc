// Drives whose limits change with position and velocity: a plan that rides on them, damaged in one way at a time, and
// the claim it must name. The damages are small: three to a hundred times the tolerance.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "core/verification/tolerances.h"
#include "core/verification/verify.h"
#include "tests/core/verification/damage.h"
#include "tests/core/verification/sample_motions.h"
#include "tests/support/independent_check.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

using testing::IsEmpty;

struct Plan {
  Problem problem;
  Trajectory trajectory;
};

/// Arm 1 under full torque up, down (it turns back) and up again, from a start that moves; arm 2 rests far away.
Plan plan_with(const TorqueLimit& limit, double friction) {
  Plan plan;
  plan.problem = paper_problem({40.0, 170.0}, {40.0, 170.0}, 0.1, 0.05);
  Arm& arm = plan.problem.arms[0];
  arm.torque = limit;
  arm.viscous_friction = friction;
  plan.problem.tasks[0].start.velocity = -0.4;
  plan.trajectory =
      driven_motion(plan.problem, {{Effort::kUpward, 1.0}, {Effort::kDownward, 1.0}, {Effort::kUpward, 0.3}}, 0.005);
  return plan;
}

Plan line_plan() { return plan_with(TorqueSpeedLine{80.0, 2.5}, 4.0); }

Plan table_plan() {
  return plan_with(TorqueTable{{0.5, 0.7, 0.9},
                               {-0.5, 0.0, 0.6},
                               {{-60.0, 75.0},
                                {-72.0, 80.0},
                                {-80.0, 60.0},
                                {-55.0, 70.0},
                                {-68.0, 75.0},
                                {-72.0, 55.0},
                                {-62.0, 78.0},
                                {-75.0, 82.0},
                                {-85.0, 62.0}}},
                   4.0);
}

Plan constant_plan() { return plan_with(Interval{-65.0, 70.0}, 4.0); }

TorqueSpeedLine& line_of(Plan& plan) { return std::get<TorqueSpeedLine>(plan.problem.arms[0].torque); }
TorqueTable& table_of(Plan& plan) { return std::get<TorqueTable>(plan.problem.arms[0].torque); }

/// A knot well inside of the first stretch.
Knot& some_knot(Plan& plan) { return plan.trajectory[0].knots[120]; }

struct Damage {
  const char* name;
  Plan (*make)();
  ViolationKind kind;
  std::function<void(Plan&)> apply;
};

const std::vector<Damage>& damages() {
  static const std::vector<Damage> kDamages = {
      {"TheStallTorqueIsLower", line_plan, ViolationKind::kTorque,
       [](Plan& p) { line_of(p).stall_torque *= 1.0 - 6e-6; }},
      {"TheNoLoadSpeedIsLower", line_plan, ViolationKind::kTorque,
       [](Plan& p) { line_of(p).no_load_speed *= 1.0 - 3e-5; }},
      {"TheLineIsConstantAtLess", line_plan, ViolationKind::kTorque,
       [](Plan& p) {
         p.problem.arms[0].torque = Interval{-79.0, 79.0};
       }},
      {"TheFrictionOfALineIsLarger", line_plan, ViolationKind::kTorque,
       [](Plan& p) { p.problem.arms[0].viscous_friction *= 1.001; }},
      {"TheFrictionOfALineIsLargerThanWritten", line_plan, ViolationKind::kTorqueColumn,
       [](Plan& p) { p.problem.arms[0].viscous_friction *= 1.001; }},
      {"AnUpperEntryOfTheTableIsLower", table_plan, ViolationKind::kTorque,
       [](Plan& p) { table_of(p).limits[4].upper -= 1e-3; }},
      {"ALowerEntryOfTheTableIsHigher", table_plan, ViolationKind::kTorque,
       [](Plan& p) { table_of(p).limits[8].lower += 1e-3; }},
      {"ACornerEntryOfTheTableIsLower", table_plan, ViolationKind::kTorque,
       [](Plan& p) { table_of(p).limits[0].upper -= 1e-3; }},
      {"ThePositionsOfTheTableAreShifted", table_plan, ViolationKind::kTorque,
       [](Plan& p) {
         for (double& position : table_of(p).positions) position += 1e-4;
       }},
      {"TheVelocitiesOfTheTableAreShifted", table_plan, ViolationKind::kTorque,
       [](Plan& p) {
         for (double& velocity : table_of(p).velocities) velocity -= 1e-4;
       }},
      {"TheFrictionOfATableIsLarger", table_plan, ViolationKind::kTorque,
       [](Plan& p) { p.problem.arms[0].viscous_friction *= 1.001; }},
      {"ThereIsNoFrictionToBrake", table_plan, ViolationKind::kTorque,
       [](Plan& p) { p.problem.arms[0].viscous_friction = 0.0; }},
      {"TheKnotsOnBendsAreMissing", table_plan, ViolationKind::kTorque,
       [](Plan& p) {
         Problem again = p.problem;
         again.tasks = {{{p.problem.tasks[0].start, {}}, p.problem.tasks[1]}};
         p.trajectory = driven_motion(again, {{Effort::kUpward, 1.0}, {Effort::kDownward, 1.3}}, 0.02, false);
       }},
      {"TheDriveIsWeakerDownward", constant_plan, ViolationKind::kTorque,
       [](Plan& p) { std::get<Interval>(p.problem.arms[0].torque).lower += 1e-3; }},
      {"TheFrictionIsLarger", constant_plan, ViolationKind::kTorque,
       [](Plan& p) { p.problem.arms[0].viscous_friction *= 1.001; }},
      {"TheFrictionIsSmallerThanWritten", constant_plan, ViolationKind::kTorqueColumn,
       [](Plan& p) { p.problem.arms[0].viscous_friction *= 0.999; }},
      {"AnAccelerationIsAboveTheLine", line_plan, ViolationKind::kTorque,
       [](Plan& p) { some_knot(p).acceleration += 1e-4; }},
      {"AnAccelerationIsAboveTheTable", table_plan, ViolationKind::kTorque,
       [](Plan& p) { some_knot(p).acceleration += 1e-4; }},
      {"AWrittenTorqueIsWrong", line_plan, ViolationKind::kTorqueColumn, [](Plan& p) { some_knot(p).torque += 1e-3; }},
      {"APositionIsShifted", table_plan, ViolationKind::kTorque, [](Plan& p) { some_knot(p).position += 1e-8; }},
      {"AVelocityIsShifted", line_plan, ViolationKind::kTorque, [](Plan& p) { some_knot(p).velocity += 1e-6; }},
      {"ALoadIsHeavierThanTold", line_plan, ViolationKind::kTorque,
       [](Plan& p) {
         p.problem.objects.push_back({"load", Capsule{{3.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, 0.05},
                                      AttachedPlacement{0, Eigen::Isometry3d::Identity(), 0.01}});
       }},
      {"TheStartVelocityIsAnother", line_plan, ViolationKind::kEndState,
       [](Plan& p) { p.problem.tasks[0].start.velocity += 2e-7; }},
      {"TheGoalVelocityIsAnother", table_plan, ViolationKind::kEndState,
       [](Plan& p) { p.problem.tasks[0].goal.velocity = 0.0; }},
  };
  return kDamages;
}

TEST(DriveMutation, TheUndamagedPlansHold) {
  for (const Plan& plan : {line_plan(), table_plan(), constant_plan()}) {
    SCOPED_TRACE(plan.problem.arms[0].torque.index());
    const Verification verification = expect_to_hold(plan.problem, plan.trajectory);
    EXPECT_NEAR(verification.torque.value, 1.0, 1e-6);
    EXPECT_THAT(independent_check(plan.problem, plan.trajectory), IsEmpty());
  }
}

class DriveMutation : public testing::TestWithParam<Damage> {};

TEST_P(DriveMutation, IsNamed) {
  Plan plan = GetParam().make();
  GetParam().apply(plan);
  expect_named(plan.problem, plan.trajectory, GetParam().kind);
}

INSTANTIATE_TEST_SUITE_P(Damage, DriveMutation, testing::ValuesIn(damages()),
                         [](const testing::TestParamInfo<Damage>& damage) { return damage.param.name; });

TEST(DriveMutation, LargerDamagesAreSeenByTheIndependentCheckToo) {
  const std::vector<std::pair<Plan (*)(), std::function<void(Plan&)>>> larger = {
      {line_plan, [](Plan& p) { line_of(p).stall_torque *= 0.999; }},
      {line_plan, [](Plan& p) { line_of(p).no_load_speed *= 0.999; }},
      {table_plan, [](Plan& p) { table_of(p).limits[4].upper -= 0.1; }},
      {table_plan, [](Plan& p) { table_of(p).positions[1] += 0.01; }},
      {constant_plan, [](Plan& p) { p.problem.arms[0].viscous_friction *= 1.001; }},
      {table_plan, [](Plan& p) { p.problem.arms[0].viscous_friction = 0.0; }},
      {line_plan, [](Plan& p) { p.problem.tasks[0].goal.velocity = 0.0; }}};
  for (std::size_t i = 0; i < larger.size(); ++i) {
    Plan plan = larger[i].first();
    larger[i].second(plan);
    EXPECT_THAT(independent_check(plan.problem, plan.trajectory), testing::Not(IsEmpty())) << i;
  }
}

/// Where the drive is weaker by a share of the torque limit itself, the verdict changes at the tolerance.
TEST(DriveMutation, TheVerdictChangesAtTheTolerance) {
  for (const auto& [weaker, holds] : {std::pair{0.9 * kTorqueTolerance, true}, {1.1 * kTorqueTolerance, false}}) {
    Plan plan = table_plan();
    for (Interval& limits : table_of(plan).limits) {
      const double half_width = 0.5 * limits.length();
      limits = {limits.lower + weaker * half_width, limits.upper - weaker * half_width};
    }
    EXPECT_EQ(verify(plan.problem, plan.trajectory, Budget()).holds(), holds) << weaker;
  }
}

}  // namespace
}  // namespace dualarm
