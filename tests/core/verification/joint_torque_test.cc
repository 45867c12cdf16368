#include "core/verification/joint_torque.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dualarm {
namespace {

Arm arm_with(double inertia, double gravity, double friction) {
  Arm arm;
  arm.inertia = inertia;
  arm.gravity = {gravity, 0.4};
  arm.viscous_friction = friction;
  return arm;
}

TEST(JointTorque, IsWhatInertiaGravityAndFrictionNeed) {
  const JointTorque torque(arm_with(3.0, 10.0, 2.0));
  EXPECT_DOUBLE_EQ(torque.at({1.2, -0.5}, 0.7), 3.0 * 0.7 + 10.0 * std::sin(0.8) - 2.0 * 0.5);
  const Quintic piece({0.0, 0.1, 0.2, 0.3, 0.0}, {0.8, 0.5, -0.4, 1.0, 0.0});
  const Quantity along = torque.along(piece);
  EXPECT_DOUBLE_EQ(along.value(0.0), torque.at({0.1, 0.2}, 0.3));
  EXPECT_NEAR(along.value(0.8), torque.at({0.5, -0.4}, 1.0), 1e-12);
}

/// Each of inertia, gravity and friction alone, so that none hides behind another, and all together.
TEST(JointTorque, CurvatureBoundsTheSecondDerivativeOverEveryInterval) {
  std::mt19937_64 random(5);
  const auto between = [&](double least, double most) { return std::uniform_real_distribution(least, most)(random); };
  for (const Arm& arm :
       {arm_with(2.0, 0.0, 0.0), arm_with(1e-9, 5.0, 0.0), arm_with(1e-9, 0.0, 3.0), arm_with(2.0, 5.0, 3.0)}) {
    const JointTorque torque(arm);
    for (int trial = 0; trial < 200; ++trial) {
      SCOPED_TRACE(testing::Message() << arm.inertia << " " << arm.viscous_friction << ", trial " << trial);
      const auto knot = [&](double time) {
        return Knot{time, between(-2.0, 2.0), between(-3.0, 3.0), between(-9.0, 9.0), 0.0};
      };
      const Quintic piece(knot(0.0), knot(between(0.3, 2.0)));
      const double begin = between(0.0, 0.9) * piece.duration();
      const Interval time = {begin, begin + between(0.01, 0.1) * piece.duration()};
      const Quantity along = torque.along(piece);
      for (int i = 0; i <= 20; ++i) {
        const double at = time.lower + time.length() * i / 20.0;
        EXPECT_LE(std::abs(torque.second_derivative(piece, at)), along.curvature(time) * (1.0 + 1e-12) + 1e-12);
      }
      const double middle = 0.5 * (time.lower + time.upper);
      const double step = 1e-4 * piece.duration();
      const double difference =
          (along.value(middle + step) - 2.0 * along.value(middle) + along.value(middle - step)) / (step * step);
      EXPECT_NEAR(torque.second_derivative(piece, middle), difference, 1e-4 * (1.0 + along.curvature(time)));
    }
  }
}

TEST(JointTorque, RoundingOfVelocitiesShowsThroughFriction) {
  const Quintic piece({100.0, 0.1, 0.2, 0.3, 0.0}, {100.01, 0.102, 0.2, 0.3, 0.0});
  const double without = JointTorque(arm_with(2.0, 0.0, 0.0)).rounding(piece);
  EXPECT_DOUBLE_EQ(without, 2.0 * piece.acceleration_rounding());
  EXPECT_DOUBLE_EQ(JointTorque(arm_with(2.0, 0.0, 1e6)).rounding(piece), without + 1e6 * piece.velocity_rounding());
  EXPECT_GT(piece.velocity_rounding(), 0.0);
}

}  // namespace
}  // namespace dualarm
