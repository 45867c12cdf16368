// A verifier is worth what it objects to: a good plan, damaged in one way at a time, and the claim it must name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numbers>

#include "core/verification/verify.h"
#include "tests/core/verification/damage.h"
#include "tests/core/verification/sample_motions.h"
#include "tests/support/independent_check.h"

namespace dualarm {
namespace {

using testing::IsEmpty;

/// Arm 1 rises through the middle, a little later arm 2 comes down through it, 0.09 m behind: a good plan with hold,
/// acceleration, braking, hold.
struct Plan {
  Problem problem;
  Trajectory trajectory;
};

Plan good_plan() {
  Plan plan;
  plan.problem = weightless_problem({20.0, 70.0}, {60.0, 20.0}, 0.1, 0.05);
  plan.trajectory = parabolic_motion(plan.problem, {0.0, 0.2});
  return plan;
}

struct Damage {
  const char* name;
  ViolationKind kind;
  std::function<void(Plan&)> apply;
};

std::vector<Knot>& knots_of(Plan& plan, int arm) { return plan.trajectory[arm].knots; }

/// The knot in the middle of the first arm's acceleration.
Knot& middle_knot(Plan& plan) { return knots_of(plan, 0)[20]; }

const std::vector<Damage>& damages() {
  static const std::vector<Damage> kDamages = {
      {"OneKnotIsShifted", ViolationKind::kTorque, [](Plan& p) { middle_knot(p).position += 1e-4; }},
      {"OneVelocityIsWrong", ViolationKind::kTorque, [](Plan& p) { middle_knot(p).velocity += 1e-3; }},
      {"TheArmsAreSwapped", ViolationKind::kArm, [](Plan& p) { std::swap(p.trajectory[0], p.trajectory[1]); }},
      {"AnArmHasTheWrongName", ViolationKind::kArm, [](Plan& p) { p.trajectory[1].arm = "arm3"; }},
      {"TheMotionsAreSwapped", ViolationKind::kEndState,
       [](Plan& p) { std::swap(p.trajectory[0].knots, p.trajectory[1].knots); }},
      {"TheGoalIsMissed", ViolationKind::kEndState, [](Plan& p) { p.problem.tasks[1].goal.position += 2e-6; }},
      {"TheStartIsMissed", ViolationKind::kEndState, [](Plan& p) { p.problem.tasks[0].start.position += 2e-6; }},
      {"TheArmArrivesMoving", ViolationKind::kEndState, [](Plan& p) { knots_of(p, 1).back().velocity = 1e-3; }},
      {"ALinkIsThicker", ViolationKind::kClearance, [](Plan& p) { p.problem.arms[0].radius += 0.05; }},
      {"ALinkIsLonger", ViolationKind::kClearance, [](Plan& p) { p.problem.arms[1].length += 0.1; }},
      {"MoreClearanceIsDemanded", ViolationKind::kClearance, [](Plan& p) { p.problem.options.clearance += 0.05; }},
      {"AnArmStartsTooEarly", ViolationKind::kClearance,
       [](Plan& p) {
         p.trajectory = parabolic_motion(p.problem, {0.0, 0.1});
       }},
      {"AnArmStartsTooLate", ViolationKind::kClearance,
       [](Plan& p) {
         p.trajectory = parabolic_motion(p.problem, {0.8, 0.9});
       }},
      {"AnObjectStandsInTheWay", ViolationKind::kClearance,
       [](Plan& p) {
         p.problem.objects.push_back({"post", Capsule{{5.0, 3.5, -1.0}, {5.0, 3.5, 1.0}, 0.05}, FixedPlacement{}});
       }},
      {"AnArmCarriesSomethingLong", ViolationKind::kClearance,
       [](Plan& p) {
         p.problem.objects.push_back(
             {"bar", Capsule{{0.0, -2.5, 0.0}, {0.0, 2.5, 0.0}, 0.05},
              AttachedPlacement{0, Eigen::Isometry3d(Eigen::Translation3d(5.5, 0.0, 0.0)), 0.0}});
       }},
      {"ALoadIsHeavierThanTold", ViolationKind::kTorqueColumn,
       [](Plan& p) {
         p.problem.objects.push_back({"load", Capsule{{3.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, 0.05},
                                      AttachedPlacement{0, Eigen::Isometry3d::Identity(), 1.0}});
       }},
      {"TheDriveIsWeaker", ViolationKind::kTorque,
       [](Plan& p) { std::get<Interval>(p.problem.arms[0].torque).upper -= 1e-3; }},
      {"TheDriveBrakesLess", ViolationKind::kTorque,
       [](Plan& p) { std::get<Interval>(p.problem.arms[1].torque).upper -= 1e-3; }},
      {"AnAccelerationIsAboveTheDrive", ViolationKind::kTorque, [](Plan& p) { middle_knot(p).acceleration += 1e-3; }},
      {"AWrittenTorqueIsWrong", ViolationKind::kTorqueColumn, [](Plan& p) { middle_knot(p).torque += 1e-3; }},
      {"WrittenTorquesAreSwapped", ViolationKind::kTorqueColumn,
       [](Plan& p) { std::swap(knots_of(p, 0).front().torque, knots_of(p, 0)[60].torque); }},
      {"TimeHasAGap", ViolationKind::kTorque,
       [](Plan& p) { knots_of(p, 0).erase(knots_of(p, 0).begin() + 20, knots_of(p, 0).begin() + 50); }},
      {"TimeRunsBackwards", ViolationKind::kKnotOrder, [](Plan& p) { middle_knot(p).time -= 0.5; }},
      {"ATimeIsNotANumber", ViolationKind::kKnotOrder,
       [](Plan& p) { middle_knot(p).time = std::numeric_limits<double>::quiet_NaN(); }},
      {"APositionIsNotANumber", ViolationKind::kKnotOrder,
       [](Plan& p) { middle_knot(p).position = std::numeric_limits<double>::quiet_NaN(); }},
      {"ATorqueIsInfinite", ViolationKind::kKnotOrder,
       [](Plan& p) { middle_knot(p).torque = std::numeric_limits<double>::infinity(); }},
      {"ANumberIsHuge", ViolationKind::kTorque, [](Plan& p) { middle_knot(p).position = 1e300; }},
      {"TimeBeginsLate", ViolationKind::kKnotOrder, [](Plan& p) { knots_of(p, 1).front().time = 0.1; }},
      {"OneArmEndsEarly", ViolationKind::kKnotOrder, [](Plan& p) { knots_of(p, 0).back().time -= 0.1; }},
      {"ThereAreNoKnots", ViolationKind::kKnotOrder, [](Plan& p) { knots_of(p, 1).clear(); }},
      {"PositionJumpsAtASwitch", ViolationKind::kContinuity,
       [](Plan& p) {
         for (Knot& knot : knots_of(p, 1)) knot.position += knot.time > 0.2 ? 1e-6 : 0.0;
         knots_of(p, 1)[2].position += 1e-6;
       }},
      {"TheVelocityLimitIsLower", ViolationKind::kVelocity, [](Plan& p) { p.problem.arms[1].velocity.lower = -1.15; }},
      {"TheJointRangeIsNarrower", ViolationKind::kJointRange,
       [](Plan& p) { p.problem.arms[0].joint_range.upper = std::numbers::pi / 3.0 - 2e-6; }},
      {"AnArcEndsElsewhere", ViolationKind::kArc, [](Plan& p) { p.trajectory[0].arcs[0].end.position += 1e-6; }},
      {"AnArcIsMissing", ViolationKind::kArc,
       [](Plan& p) { p.trajectory[0].arcs.erase(p.trajectory[0].arcs.begin() + 1); }},
      {"AnArcIsNotANumber", ViolationKind::kArc,
       [](Plan& p) { p.trajectory[0].arcs[1].end_time = std::numeric_limits<double>::quiet_NaN(); }},
      {"AnArcClaimsToHold", ViolationKind::kArc, [](Plan& p) { p.trajectory[0].arcs[0].kind = ArcKind::kHold; }},
      {"AWholeMotionClaimsToCruise", ViolationKind::kArc,
       [](Plan& p) {
         auto& arcs = p.trajectory[0].arcs;
         arcs = {
             {ArcKind::kCruise, arcs.front().start_time, arcs.back().end_time, arcs.front().start, arcs.back().end}};
       }},
      {"AnArcClaimsToCruise", ViolationKind::kArc, [](Plan& p) { p.trajectory[0].arcs[0].kind = ArcKind::kCruise; }},
      {"TheStartTimeIsLaterThanTheMotion", ViolationKind::kArc, [](Plan& p) { p.trajectory[1].start_time += 0.01; }},
      {"TheArmMovesBeforeItsStartTime", ViolationKind::kArc,
       [](Plan& p) {
         p.trajectory[1].start_time += 0.01;
         p.trajectory[1].duration -= 0.01;
       }},
      {"TheDurationIsShorterThanTheMotion", ViolationKind::kArc, [](Plan& p) { p.trajectory[0].duration -= 0.01; }},
  };
  return kDamages;
}

TEST(Mutation, TheUndamagedPlanHolds) {
  const Plan plan = good_plan();
  expect_to_hold(plan.problem, plan.trajectory);
  EXPECT_THAT(independent_check(plan.problem, plan.trajectory), IsEmpty());
}

class Mutation : public testing::TestWithParam<Damage> {};

TEST_P(Mutation, IsNamed) {
  Plan plan = good_plan();
  GetParam().apply(plan);
  expect_named(plan.problem, plan.trajectory, GetParam().kind);
}

TEST_P(Mutation, IsSeenByTheIndependentCheckWhereSamplesCanSeeIt) {
  Plan plan = good_plan();
  GetParam().apply(plan);
  const std::vector<ViolationKind> visible = {ViolationKind::kArm, ViolationKind::kEndState, ViolationKind::kClearance,
                                              ViolationKind::kJointRange};
  if (std::find(visible.begin(), visible.end(), GetParam().kind) == visible.end()) return;
  EXPECT_THAT(independent_check(plan.problem, plan.trajectory), testing::Not(IsEmpty()));
}

TEST(Mutation, WrongDynamicsAreSeenByTheIndependentCheck) {
  for (const double factor : {0.999, 1.001}) {
    Plan plan = good_plan();
    for (Knot& knot : knots_of(plan, 0)) knot.torque *= factor;
    EXPECT_THAT(independent_check(plan.problem, plan.trajectory), testing::Not(IsEmpty())) << factor;
  }
}

INSTANTIATE_TEST_SUITE_P(Damage, Mutation, testing::ValuesIn(damages()),
                         [](const testing::TestParamInfo<Damage>& damage) { return damage.param.name; });

}  // namespace
}  // namespace dualarm
