#include "core/refuse_blocked.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/problems.h"

namespace dualarm {
namespace {

using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

/// An arm without gravity: 3 rad/s2 both ways, range [0, pi], |velocity| <= 2 rad/s.
Arm light_arm() {
  Arm arm = paper_problem({20, 70}, {60, 20}).arms[0];
  arm.inertia = 20.0;
  arm.gravity.amplitude = 0.0;
  return arm;
}

/// What the planner would answer for a task of that arm; the arm must be blocked.
Infeasible refusal_of(const Arm& arm, const Task& task, const FreeRange& free) {
  Arm within = arm;
  within.joint_range = free.range;
  const SingleJointArm system(within);
  const auto motion = fastest_motion(system, task.start, task.goal);
  const auto* blocked = std::get_if<Blocked>(&motion);
  if (blocked == nullptr) {
    ADD_FAILURE() << "not blocked";
    return {};
  }
  return refuse_blocked(arm, task, system, free, *blocked);
}

FreeRange whole(const Arm& arm) { return {arm.joint_range, {}, {}, {}, {}}; }

TEST(RefuseBlocked, SaysHowMuchRoomAStartNeedsThatIsTooFast) {
  const Arm arm = light_arm();
  // Braking at 3 rad/s2 from 1.9 rad/s takes 0.601667 rad.
  const Infeasible refusal = refusal_of(arm, {{2.9, 1.9}, {1.0, 0.0}}, whole(arm));
  EXPECT_EQ(refusal.reason, InfeasibleReason::kStartTooFast);
  const double left = std::sqrt(1.9 * 1.9 - 6.0 * (kPi - 2.9));
  EXPECT_EQ(refusal.evidence.arm, "arm1");
  EXPECT_NEAR(refusal.evidence.position.value(), kPi, 1e-12);
  EXPECT_NEAR(refusal.evidence.velocity.value(), left, 1e-9);
  EXPECT_NEAR(refusal.evidence.relaxation.value(), 2.9 + 1.9 * 1.9 / 6.0 - kPi, 1e-9);
  EXPECT_THAT(refusal.explanation, HasSubstr("arm1 starts with 1.9 rad/s at 2.9 rad"));
  EXPECT_THAT(refusal.explanation, HasSubstr("braking with full torque it is still at 1.46984"));
  EXPECT_THAT(refusal.explanation, HasSubstr("rad/s at the end of its joint range, 3.14159 rad; start slower"));
  EXPECT_THAT(refusal.explanation, HasSubstr("give 0.360074 rad more room"));
}

TEST(RefuseBlocked, SaysHowMuchRoomAGoalNeedsThatIsTooFast) {
  const Arm arm = light_arm();
  const Infeasible refusal = refusal_of(arm, {{1.0, 0.0}, {0.2, 1.9}}, whole(arm));
  EXPECT_EQ(refusal.reason, InfeasibleReason::kGoalTooFast);
  EXPECT_EQ(refusal.evidence.position.value(), 0.0);
  EXPECT_NEAR(refusal.evidence.velocity.value(), std::sqrt(1.9 * 1.9 - 6.0 * 0.2), 1e-9);
  EXPECT_NEAR(refusal.evidence.relaxation.value(), 1.9 * 1.9 / 6.0 - 0.2, 1e-9);
  EXPECT_THAT(refusal.explanation, HasSubstr("arm1 has to arrive with 1.9 rad/s at 0.2 rad"));
  EXPECT_THAT(refusal.explanation, HasSubstr("would have to pass the end of its joint range, 0 rad, at 1.55"));
}

TEST(RefuseBlocked, NamesTheObjectThatLeavesTooLittleRoom) {
  const Arm arm = light_arm();
  const FreeRange free{{0.0, 2.0}, "", "post", "", "gripper"};
  const Infeasible refusal = refusal_of(arm, {{1.9, 1.9}, {1.0, 0.0}}, free);
  EXPECT_EQ(refusal.reason, InfeasibleReason::kStartTooFast);
  EXPECT_EQ(refusal.evidence.first_body, "gripper");
  EXPECT_EQ(refusal.evidence.second_body, "post");
  EXPECT_THAT(refusal.explanation, HasSubstr("2 rad, where post stands in its way"));
}

TEST(RefuseBlocked, SaysThatAStartLeavesTheRangeAtOnce) {
  const Arm arm = light_arm();
  const Infeasible refusal = refusal_of(arm, {{0.0, -0.6}, {1.0, 0.0}}, whole(arm));
  EXPECT_EQ(refusal.reason, InfeasibleReason::kStartTooFast);
  EXPECT_NEAR(refusal.evidence.relaxation.value(), 0.06, 1e-9);
  EXPECT_THAT(refusal.explanation, HasSubstr("and leaves the end of its joint range"));
}

TEST(RefuseBlocked, DoesNotAdviseToStartSlowerWhereGravityHasTheBetterOfTheDrive) {
  // At a quarter of a turn gravity takes 100 N m of the drive's 60: the arm falls however slowly it starts.
  Arm arm = light_arm();
  arm.gravity.amplitude = 100.0;
  const Infeasible falling = refusal_of(arm, {{0.8, -0.3}, {2.9, 0.0}}, {{0.7, kPi}, {}, {}, {}, {}});
  EXPECT_EQ(falling.reason, InfeasibleReason::kStartTooFast);
  EXPECT_THAT(falling.explanation, testing::Not(HasSubstr("slower")));
}

TEST(RefuseBlocked, SaysByHowMuchAVelocityBreaksItsLimit) {
  const Arm arm = light_arm();
  const Infeasible start = refusal_of(arm, {{1.0, 2.5}, {2.0, 0.0}}, whole(arm));
  EXPECT_EQ(start.reason, InfeasibleReason::kStartTooFast);
  EXPECT_EQ(start.evidence.velocity.value(), 2.5);
  EXPECT_EQ(start.evidence.relaxation.value(), 0.5);
  EXPECT_THAT(start.explanation, HasSubstr("0.5 rad/s beyond its velocity limits [-2, 2] rad/s"));
  const Infeasible goal = refusal_of(arm, {{1.0, 0.0}, {2.0, -2.25}}, whole(arm));
  EXPECT_EQ(goal.reason, InfeasibleReason::kGoalTooFast);
  EXPECT_EQ(goal.evidence.relaxation.value(), 0.25);
  EXPECT_THAT(goal.explanation, HasSubstr("arrive slower"));
}

TEST(RefuseBlocked, GivesTheTorqueThatIsMissingAtTheStateItself) {
  // Gravity drives the arm down faster than friction and the drive at that speed can hold it.
  Arm arm = light_arm();
  arm.gravity.amplitude = 100.0;
  arm.viscous_friction = 4.0;
  arm.torque = TorqueTable{{0.0}, {-2.0, 0.0}, {{-60.0, 20.0}, {-60.0, 60.0}}};
  const SingleJointArm system(arm);
  const Blocked blocked{BlockReason::kVelocityLimit, 1.5, -2.0, Extreme::kHighest, true, 0.0};
  const Infeasible refusal = refuse_blocked(arm, {{1.6, -1.9}, {1.0, 0.0}}, system, whole(arm), blocked);
  EXPECT_EQ(refusal.reason, InfeasibleReason::kVelocityLimit);
  const double needed = 100.0 * std::sin(1.5) - 4.0 * 2.0;
  EXPECT_NEAR(refusal.evidence.needed_torque.value(), needed, 1e-9);
  EXPECT_NEAR(refusal.evidence.available_torque.value(), 20.0, 1e-12);
  EXPECT_EQ(refusal.evidence.velocity.value(), -2.0);
  EXPECT_THAT(refusal.explanation, HasSubstr("cannot keep its velocity limits [-2, 2] rad/s"));
  EXPECT_THAT(refusal.explanation, HasSubstr("it still gets faster than -2 rad/s at 1.5 rad"));
  EXPECT_THAT(refusal.explanation, HasSubstr("keeping that velocity needs 91.7495 N m and 20 N m are available"));
}

TEST(RefuseBlocked, NamesTheVelocityLimitThatKeepsAnArmFromGettingPastGravity) {
  // Gravity has the better of the drive from asin(0.8) on; braked through there, the arm comes down with 1.30536 rad/s.
  Arm arm = light_arm();
  arm.inertia = 1.0;
  arm.gravity.amplitude = 5.0;
  arm.torque = Interval{-4.0, 4.0};
  arm.velocity = {-1.0, 1.0};
  const double loss = 6.0 - 4.0 * (kPi - 2.0 * std::asin(0.8));
  const Infeasible down = refusal_of(arm, {{3.0, 0.0}, {0.1, 0.0}}, whole(arm));
  EXPECT_EQ(down.reason, InfeasibleReason::kVelocityLimit);
  EXPECT_NEAR(down.evidence.position.value(), std::asin(0.8), 1e-9);
  EXPECT_EQ(down.evidence.velocity.value(), -1.0);
  EXPECT_NEAR(down.evidence.relaxation.value(), std::sqrt(2.0 * loss) - 1.0, 1e-5);
  EXPECT_FALSE(down.evidence.needed_torque);
  EXPECT_THAT(down.explanation, HasSubstr("braking with full torque, it still gets faster than -1 rad/s at 0.927295"));
  EXPECT_THAT(down.explanation, HasSubstr("give it a velocity limit 0.305"));
  const Infeasible up = refusal_of(arm, {{0.1, 0.0}, {3.0, 0.0}}, whole(arm));
  EXPECT_THAT(up.explanation, HasSubstr("even with full torque from 1 rad/s at 0.927295"));
  EXPECT_THAT(up.explanation, HasSubstr("it does not get past what follows"));
}

TEST(RefuseBlocked, SaysThatADriveHasNoTorqueAboveItsNoLoadSpeed) {
  Arm arm = light_arm();
  arm.torque = TorqueSpeedLine{1.0, 1.0};
  arm.joint_range = {-100.0, 100.0};
  const Infeasible refusal = refusal_of(arm, {{0.0, 0.0}, {1.0, 1.5}}, whole(arm));
  EXPECT_EQ(refusal.reason, InfeasibleReason::kGoalTooFast);
  EXPECT_FALSE(refusal.evidence.relaxation);
  EXPECT_THAT(refusal.explanation, HasSubstr("arrive slower, or give it a drive with a higher no-load speed"));
  EXPECT_THAT(refusal.explanation, testing::Not(HasSubstr("larger range")));
}

TEST(RefuseBlocked, SaysThatADriveCannotGiveLess) {
  Arm arm = light_arm();
  arm.torque = Interval{10.0, 60.0};
  const Infeasible start = refusal_of(arm, {{1.0, 0.0}, {2.0, 0.0}}, whole(arm));
  EXPECT_EQ(start.reason, InfeasibleReason::kStartNotHoldable);
  EXPECT_THAT(start.explanation, HasSubstr("gravity needs 0 N m, and the drive gives no less than 10 N m"));
  EXPECT_THAT(start.explanation, testing::Not(HasSubstr("more torque")));
  arm.gravity.amplitude = 30.0;
  const Infeasible goal = refusal_of(arm, {{kPi / 2, 0.0}, {kPi, 0.0}}, whole(arm));
  EXPECT_EQ(goal.reason, InfeasibleReason::kGoalNotHoldable);
  EXPECT_THAT(goal.explanation, HasSubstr("the drive gives no less than 10 N m"));
}

TEST(RefuseBlocked, GivesAsManyDigitsAsTellNumbersApart) {
  Arm arm = light_arm();
  arm.gravity.amplitude = 1.0;
  arm.torque = Interval{-(1.0 - 1e-9), 1.0 - 1e-9};
  const Infeasible near = refusal_of(arm, {{kPi / 2, 0.0}, {kPi, 0.0}}, whole(arm));
  EXPECT_THAT(near.explanation, HasSubstr("gravity needs 1 N m and 0.999999999 N m are available"));
  const Blocked balanced{BlockReason::kStalls, kPi / 2, 0.0, Extreme::kHighest, false};
  arm.torque = Interval{-1.0, 1.0};
  const Infeasible none = refuse_blocked(arm, {{kPi / 2, 0.0}, {kPi, 0.0}}, SingleJointArm(arm), whole(arm), balanced);
  EXPECT_THAT(none.explanation, HasSubstr("gravity needs all of the 1 N m that are available"));
}

TEST(RefuseBlocked, ComparesNoTorquesWhereOnlyTheWayWasTooShort) {
  const Arm arm = light_arm();
  const Blocked blocked{BlockReason::kCannotBrake, 1.0, 0.0, Extreme::kLowest, false, 0.0};
  const Infeasible refusal = refuse_blocked(arm, {{0.9, 1.9}, {1.0, 0.0}}, SingleJointArm(arm), whole(arm), blocked);
  EXPECT_EQ(refusal.reason, InfeasibleReason::kTorqueTooSmall);
  EXPECT_FALSE(refusal.evidence.needed_torque);
  EXPECT_FALSE(refusal.evidence.relaxation);
  EXPECT_EQ(refusal.evidence.available_torque.value(), -60.0);
  EXPECT_THAT(refusal.explanation, HasSubstr("does not do it on the way"));
}

TEST(RefuseBlocked, SaysByHowMuchAnEndIsOutsideTheRange) {
  const Arm arm = light_arm();
  const Infeasible refusal = refusal_of(arm, {{-0.25, 0.0}, {1.0, 0.0}}, whole(arm));
  EXPECT_EQ(refusal.reason, InfeasibleReason::kStartOutsideRange);
  EXPECT_EQ(refusal.evidence.relaxation.value(), 0.25);
}

}  // namespace
}  // namespace dualarm
