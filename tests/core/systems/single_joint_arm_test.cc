#include "core/systems/single_joint_arm.h"

#include <limits>

#include "tests/core/phase_plane/test_arms.h"
#include "tests/core/systems/limited_arms.h"

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

}  // namespace
}  // namespace dualarm
