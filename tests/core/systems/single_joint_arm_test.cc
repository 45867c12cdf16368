#include "core/systems/single_joint_arm.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/core/phase_plane/test_arms.h"
#include "tests/core/systems/limited_arms.h"
#include "tests/support/dice.h"

namespace dualarm {
namespace {

INSTANTIATE_TEST_SUITE_P(SingleJointArm, SystemLaws, testing::ValuesIn(arms_with_every_limit()), family_name);

TEST(SingleJointArm, NeedsTheTorqueOfItsEquationOfMotion) {
  Arm arm = pendulum(4.0, 3.0, 9.0);
  arm.gravity.phase = 0.5;
  const SingleJointArm system(arm);
  EXPECT_DOUBLE_EQ(system.torque({1.2, 0.0}, -2.0), 4.0 * -2.0 + 3.0 * std::sin(0.7));
}

TEST(SingleJointArm, UsesItsWholeTorqueAtTheEndsOfItsAccelerations) {
  const SingleJointArm system(pendulum(4.0, 3.0, 9.0));
  EXPECT_DOUBLE_EQ(system.torque({0.9, 0.0}, system.acceleration(0.9, 0.0).upper), 9.0);
  EXPECT_DOUBLE_EQ(system.torque({0.9, 0.0}, system.acceleration(0.9, 0.0).lower), -9.0);
}

TEST(SingleJointArm, SpendsTorqueOnFriction) {
  Arm arm = pendulum(4.0, 3.0, 9.0);
  arm.viscous_friction = 0.5;
  const SingleJointArm system(arm);
  EXPECT_DOUBLE_EQ(system.torque({0.0, 2.0}, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(system.torque({0.9, 2.0}, system.acceleration(0.9, 2.0).upper), 9.0);
  EXPECT_DOUBLE_EQ(system.acceleration(0.0, 2.0).upper, (9.0 - 1.0) / 4.0);
}

TEST(SingleJointArm, HasTheTorqueOfItsLineAndTable) {
  Arm arm = pendulum(4.0, 0.0, 9.0);
  arm.torque = TorqueSpeedLine{8.0, 4.0};
  EXPECT_EQ(SingleJointArm(arm).acceleration(0.0, 1.0), (Interval{-2.0, 1.5}));
  EXPECT_EQ(SingleJointArm(arm).acceleration(0.0, -1.0), (Interval{-1.5, 2.0}));
  arm.torque = TorqueTable{{0.0, 1.0}, {0.0, 1.0}, {{-4.0, 4.0}, {-4.0, 8.0}, {-8.0, 4.0}, {-8.0, 8.0}}};
  EXPECT_EQ(SingleJointArm(arm).acceleration(0.5, 0.5), (Interval{-1.5, 1.5}));
}

TEST(SingleJointArm, HasNoBoundsWithFrictionAndEndlessVelocity) {
  Arm arm = pendulum(4.0, 3.0, 9.0);
  EXPECT_DOUBLE_EQ(SingleJointArm(arm).acceleration_bounds().upper, 3.0);
  arm.viscous_friction = 0.5;
  EXPECT_EQ(SingleJointArm(arm).acceleration_bounds().lower, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(SingleJointArm(arm).acceleration_bounds().upper, std::numeric_limits<double>::infinity());
}

/// Steps from far too small to far too large to share a sine, and limits of every kind.
TEST(SingleJointArm, DrivesAlongAMotionAreThoseOfItsStates) {
  Dice dice(31);
  Arm arm = pendulum(4.0, 3.0, 9.0);
  for (int trial = 0; trial < 500; ++trial) {
    SCOPED_TRACE(trial);
    arm.gravity.phase = dice.between(-3.0, 3.0);
    arm.viscous_friction = dice.happens(0.3) ? 0.5 : 0.0;
    arm.torque = dice.happens(0.8) ? TorqueLimit(Interval{-9.0, 7.0}) : TorqueSpeedLine{8.0, 4.0};
    const SingleJointArm system(arm);
    const double step = std::pow(10.0, dice.between(-9.0, 0.0));
    std::vector<Knot> knots = {{0.0, dice.between(-9.0, 9.0), 0.0, 0.0, 0.0}};
    const auto count = static_cast<std::size_t>(dice.between(1.0, 40.0));
    while (knots.size() < count) {
      const double position = knots.back().position + step * dice.between(-0.5, 1.0);
      knots.push_back({0.0, position, dice.between(-3.0, 3.0), 0.0, 0.0});
    }
    for (const auto extreme :
         {std::optional(Extreme::kLowest), std::optional(Extreme::kHighest), std::optional<Extreme>()}) {
      system.drive(extreme, knots);
      for (const Knot& knot : knots) {
        const SingleJointArm::Drive expected = system.drive(extreme, {knot.position, knot.velocity});
        const double rounding = 1e-15 + 3.0 * 4e-16 * (1.0 + std::abs(knot.position));  // gravity's, of the angle
        ASSERT_NEAR(knot.acceleration, expected.acceleration, rounding / 4.0);
        ASSERT_NEAR(knot.torque, expected.torque, rounding);
      }
    }
  }
}

TEST(SingleJointArm, TheSixthDerivativeIsNoLargerThanItsBound) {
  Dice dice(32);
  double closest = 0.0;
  for (int trial = 0; trial < 2000; ++trial) {
    Arm arm = pendulum(dice.between(1.0, 9.0), dice.between(-9.0, 9.0), dice.between(1.0, 30.0));
    arm.viscous_friction = dice.happens(0.5) ? dice.between(0.0, 5.0) : 0.0;
    const SingleJointArm system(arm);
    const JointState state = {dice.between(-3.0, 3.0), dice.between(-3.0, 3.0)};
    const Extreme extreme = dice.happens(0.5) ? Extreme::kLowest : Extreme::kHighest;
    std::array<double, 7> way;
    ASSERT_TRUE(system.extremal_series(extreme, state, way));
    const double bound =
        system.most_sixth_derivative(std::abs(state.velocity), std::abs(system.drive(extreme, state).acceleration));
    ASSERT_LE(std::abs(720.0 * way[6]), bound * (1.0 + 1e-12)) << trial;
    closest = std::max(closest, std::abs(720.0 * way[6]) / bound);
  }
  EXPECT_GT(closest, 0.8);
}

}  // namespace
}  // namespace dualarm
