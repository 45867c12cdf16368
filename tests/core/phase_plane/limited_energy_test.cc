#include "core/phase_plane/limited_energy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/phase_plane/swing.h"
#include "core/phase_plane/time_optimal.h"
#include "core/phase_plane/turns.h"
#include "core/systems/single_joint_arm.h"
#include "tests/core/phase_plane/test_arms.h"
#include "tests/support/dice.h"

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;
/// Gravity takes 5 N m of the drive's 4: between these two positions it has the better of the drive.
const double kWeakFrom = std::asin(0.8);
const double kWeakTo = kPi - kWeakFrom;
/// Energy lost on the way up through there, or won on the way down, at full torque, and the speed that it takes.
const double kLoss = 2.0 * 5.0 * std::cos(kWeakFrom) - 4.0 * (kWeakTo - kWeakFrom);
const double kSpeed = std::sqrt(2.0 * kLoss);

Arm weak_arm(double velocity) {
  Arm arm = pendulum(1.0, 5.0, 4.0);
  arm.joint_range = {0.0, kPi};
  arm.velocity = {-velocity, velocity};
  return arm;
}

Blocked must_block(const Arm& arm, double start, double goal) {
  const auto motion = fastest_motion(SingleJointArm(arm), start, goal);
  EXPECT_TRUE(std::holds_alternative<Blocked>(motion)) << start << " -> " << goal;
  return std::holds_alternative<Blocked>(motion) ? std::get<Blocked>(motion) : Blocked{};
}

TEST(LimitedEnergy, ProvesThatAVelocityLimitMakesAWayDownImpossible) {
  const Blocked down = must_block(weak_arm(1.0), 3.0, 0.1);
  EXPECT_TRUE(down.is_proven);
  EXPECT_EQ(down.reason, BlockReason::kVelocityLimit);
  EXPECT_NEAR(down.position, kWeakFrom, 1e-12);
  EXPECT_EQ(down.velocity, -1.0);
  EXPECT_EQ(down.extreme, Extreme::kHighest);
}

TEST(LimitedEnergy, ProvesThatAVelocityLimitMakesAWayUpImpossible) {
  const Blocked up = must_block(weak_arm(1.0), 0.1, 3.0);
  EXPECT_TRUE(up.is_proven);
  EXPECT_EQ(up.reason, BlockReason::kVelocityLimit);
  EXPECT_NEAR(up.position, kWeakFrom, 1e-12);
  EXPECT_EQ(up.velocity, 1.0);
  EXPECT_EQ(up.extreme, Extreme::kHighest);
}

TEST(LimitedEnergy, RunsOutExactlyBelowTheSpeedThatGetsPast) {
  for (const double share : {-1e-3, -1e-6, -1e-9, 1e-9, 1e-6, 1e-3}) {
    SCOPED_TRACE(share);
    const SingleJointArm system(weak_arm(kSpeed * (1.0 + share)));
    EXPECT_EQ(limit_break(system, {3.0, 0.0}, {0.1, 0.0}).has_value(), share < 0.0);
    EXPECT_EQ(limit_break(system, {0.1, 0.0}, {3.0, 0.0}).has_value(), share < 0.0);
  }
}

TEST(LimitedEnergy, IsLeftToTheTorqueWhereThatAloneIsTooSmall) {
  // From 0.5 rad on, the range leaves no run-up that would do at any speed.
  Arm arm = weak_arm(1.0);
  arm.joint_range = {0.5, 2.9};
  const Blocked blocked = must_block(arm, 0.5, 2.9);
  EXPECT_TRUE(blocked.is_proven);
  EXPECT_EQ(blocked.reason, BlockReason::kStalls);
}

TEST(LimitedEnergy, IsFollowedThroughFrictionAndTorqueSpeedLines) {
  Arm friction = weak_arm(1.2);
  friction.viscous_friction = 0.2;
  EXPECT_EQ(must_block(friction, 0.1, 3.0).reason, BlockReason::kVelocityLimit);
  // Downwards friction helps: what it takes makes up for the speed that the limit lacks.
  EXPECT_TRUE(limit_break(SingleJointArm(weak_arm(1.2)), {3.0, 0.0}, {0.1, 0.0}));
  EXPECT_FALSE(limit_break(SingleJointArm(friction), {3.0, 0.0}, {0.1, 0.0}));
  Arm line = weak_arm(1.0);
  line.torque = TorqueSpeedLine{4.0, 100.0};
  const auto broken = limit_break(SingleJointArm(line), {0.1, 0.0}, {3.0, 0.0});
  ASSERT_TRUE(broken);
  EXPECT_NEAR(broken->position, std::asin(0.8 * 0.99), 1e-9);  // at 1 rad/s a hundredth of the torque is gone
}

TEST(LimitedEnergy, DoesNotRunOutWithoutALimitOrAWay) {
  Arm arm = weak_arm(1.0);
  arm.velocity = {-HUGE_VAL, HUGE_VAL};
  EXPECT_FALSE(limit_break(SingleJointArm(arm), {3.0, 0.0}, {0.1, 0.0}));
  EXPECT_FALSE(limit_break(SingleJointArm(weak_arm(1.0)), {0.1, 0.5}, {0.1, 0.0}));
}

TEST(LimitedEnergy, MayComeFromFartherAwayThanARevolution) {
  // Past [0.5, 1.5] the drive only pushes back; what gets there got its speed 7 rad before the start.
  Arm arm = pendulum(1.0, 0.0, 1.0);
  arm.joint_range = {-10.0, 5.0};
  arm.velocity = {-3.0, 3.0};
  arm.torque = TorqueTable{{-7.0, -6.5, 0.4, 0.5, 1.5, 1.6},
                           {0.0},
                           {{-20.0, 20.0}, {-20.0, 0.01}, {-20.0, 0.01}, {-20.0, -2.0}, {-20.0, -2.0}, {-20.0, 20.0}}};
  const SingleJointArm system(arm);
  EXPECT_FALSE(limit_break(system, {0.0, 0.0}, {3.0, 0.0}));
  EXPECT_TRUE(std::holds_alternative<std::vector<Arc>>(motion_through(system, {0.0, 0.0}, {-9.0}, {3.0, 0.0})));
}

TorqueTable some_table(Dice& dice, double torque) {
  TorqueTable table;
  double position = dice.between(-3.0, 0.0);
  for (int i = 0; i < 3; ++i) table.positions.push_back(position += dice.between(0.3, 2.0));
  double velocity = dice.between(-2.0, 0.0);
  for (int i = 0; i < 2; ++i) table.velocities.push_back(velocity += dice.between(0.3, 2.0));
  for (int i = 0; i < 6; ++i)
    table.limits.push_back({-torque * dice.between(0.6, 1.3), torque * dice.between(0.6, 1.3)});
  return table;
}

/// Arms mostly too weak for gravity, under every limit, with a velocity limit that is near what they need.
Arm some_arm(Dice& dice) {
  Arm arm = pendulum(std::exp(dice.between(-1.0, 2.0)), 1.0, 1.0);
  arm.gravity = {std::exp(dice.between(-1.0, 2.0)), dice.between(-3.0, 3.0)};
  const double torque = arm.gravity.amplitude * dice.between(0.5, 1.05);
  arm.torque = Interval{-torque * dice.between(0.8, 1.2), torque * dice.between(0.8, 1.2)};
  const double speed = std::sqrt(arm.gravity.amplitude / arm.inertia);
  switch (dice.one_of(4)) {
    case 0:
      arm.torque = TorqueSpeedLine{torque, speed * dice.between(0.5, 5.0)};
      break;
    case 1:
      arm.torque = some_table(dice, torque);
      break;
    case 2:
      arm.viscous_friction = torque / speed * std::exp(dice.between(-4.0, 0.0));
      break;
    default:
      break;
  }
  arm.joint_range = {dice.between(-8.0, -1.0), dice.between(1.0, 8.0)};
  arm.velocity = {-speed * dice.between(0.1, 1.2), speed * dice.between(0.1, 1.2)};
  return arm;
}

TEST(LimitedEnergy, NeverRunsOutOnAMotionThatExists) {
  constexpr unsigned kSeed = 31;
  SCOPED_TRACE(kSeed);
  Dice dice(kSeed);
  int motions = 0;
  int breaks = 0;
  for (int round = 0; round < 4000; ++round) {
    const Arm arm = some_arm(dice);
    const SingleJointArm system(arm);
    const auto some_state = [&] {
      const double velocity = dice.one_of(2) == 0 ? 0.0 : dice.between(arm.velocity.lower, arm.velocity.upper);
      return JointState{dice.between(arm.joint_range.lower, arm.joint_range.upper), velocity};
    };
    const JointState start = some_state();
    const JointState goal = some_state();
    const auto broken = limit_break(system, start, goal);
    breaks += broken.has_value() ? 1 : 0;
    // The search for swings takes a while: only some of those that the proof calls impossible.
    const bool search = broken && round % 40 == 0;
    const auto motion = fastest_motion(system, start, goal, Swings::kSkip);
    const bool moves = std::holds_alternative<FastestMotion>(motion);
    motions += moves ? 1 : 0;
    ASSERT_FALSE(moves && broken) << "round " << round << ": " << start.position << " " << start.velocity << " -> "
                                  << goal.position << " " << goal.velocity << " broken at " << broken->position;
    if (!search || std::get<Blocked>(motion).reason < BlockReason::kStartTooFast) continue;
    ASSERT_FALSE(fastest_swing(system, start, goal, HUGE_VAL, Budget())) << "round " << round;
  }
  EXPECT_GT(motions, 400);
  EXPECT_GT(breaks, 400);
}

}  // namespace
}  // namespace dualarm
