#include "core/verification/joint_torque.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/core/verification/loaded_arm.h"

namespace dualarm {
namespace {

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

TEST(JointTorque, StaysInItsIntervalOverEveryPiece) {
  std::mt19937_64 random(6);
  const auto between = [&](double least, double most) { return std::uniform_real_distribution(least, most)(random); };
  for (const Arm& arm :
       {arm_with(2.0, 0.0, 0.0), arm_with(1e-9, 5.0, 0.0), arm_with(1e-9, 0.0, 3.0), arm_with(2.0, 5.0, 3.0)}) {
    const JointTorque torque(arm);
    for (int trial = 0; trial < 300; ++trial) {
      SCOPED_TRACE(testing::Message() << arm.inertia << " " << arm.viscous_friction << ", trial " << trial);
      const auto knot = [&](double time) {
        return Knot{time, between(-2.0, 2.0), between(-3.0, 3.0), between(-9.0, 9.0), 0.0};
      };
      const Quintic piece(knot(1.0), knot(1.0 + std::pow(10.0, between(-2.5, 0.5))));
      const Interval range = torque.over(piece);
      const double rounding = 1e-12 * (1.0 + std::abs(range.lower) + std::abs(range.upper));
      const Quantity along = torque.along(piece);
      for (int i = 0; i <= 50; ++i) {
        const double value = along.value(std::lerp(piece.time().lower, piece.time().upper, i / 50.0));
        EXPECT_LE(value, range.upper + rounding);
        EXPECT_GE(value, range.lower - rounding);
      }
    }
  }
}

/// A motion of constant torque: the quintic departs from it by some 1e-9, and the interval adds less.
TEST(JointTorque, IntervalIsTightWhereTheTorqueIsConstant) {
  const Arm arm = arm_with(2.0, 5.0, 0.0);
  const JointTorque torque(arm);
  constexpr double kTorque = 7.0;
  const auto acceleration = [&](double position) { return (kTorque - 5.0 * std::sin(position - 0.4)) / 2.0; };
  const auto knot_after = [&](const Knot& from, double time) {
    Knot to = from;
    constexpr int kSteps = 1000;
    const double h = time / kSteps;
    for (int i = 0; i < kSteps; ++i) {  // Runge, Kutta and Nystroem
      const double k1 = acceleration(to.position);
      const double k2 = acceleration(to.position + 0.5 * h * to.velocity + 0.125 * h * h * k1);
      const double k3 = acceleration(to.position + h * to.velocity + 0.5 * h * h * k2);
      to.position += h * to.velocity + h * h / 6.0 * (k1 + 2.0 * k2);
      to.velocity += h / 6.0 * (k1 + 4.0 * k2 + k3);
    }
    to.time += time;
    to.acceleration = acceleration(to.position);
    return to;
  };
  const Knot start = {0.0, 0.3, 0.9, acceleration(0.3), 0.0};
  const Quintic piece(start, knot_after(start, 0.01));
  const Interval range = torque.over(piece);
  EXPECT_NEAR(range.lower, kTorque, 1e-8);
  EXPECT_NEAR(range.upper, kTorque, 1e-8);
  double least = kTorque;
  double most = kTorque;
  for (int i = 0; i <= 1000; ++i) {
    const double value = torque.along(piece).value(0.01 * i / 1000.0);
    least = std::min(least, value);
    most = std::max(most, value);
  }
  EXPECT_NEAR(range.lower, least, 5e-10);
  EXPECT_NEAR(range.upper, most, 5e-10);
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
