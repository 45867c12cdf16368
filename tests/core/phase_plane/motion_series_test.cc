#include "core/phase_plane/motion_series.h"

#include <gtest/gtest.h>

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <numbers>
#include <vector>

#include "core/phase_plane/extremal_rate.h"
#include "core/systems/single_joint_arm.h"
#include "tests/core/phase_plane/test_arms.h"
#include "tests/support/dice.h"

namespace dualarm {
namespace {

constexpr double kMost = 3.0;  // s

/// The way and the velocity after a time, by many small steps.
PlaneState integrated(const System& system, Extreme extreme, JointState from, double time) {
  constexpr int kSteps = 400;
  boost::numeric::odeint::runge_kutta_fehlberg78<PlaneState> stepper;
  PlaneState state = {0.0, from.velocity};
  for (int i = 0; i < kSteps; ++i) {
    stepper.do_step(extremal_rate(system, extreme, from.position), state, 0.0, time / kSteps);
  }
  return state;
}

void expect_the_motion(const Arm& arm, JointState from) {
  const SingleJointArm system(arm);
  for (const Extreme extreme : {Extreme::kLowest, Extreme::kHighest}) {
    const auto series = MotionSeries::about(system, extreme, from);
    ASSERT_TRUE(series);
    const double reach = series->reach(kMost);
    EXPECT_GT(reach, 0.01 * std::sqrt(arm.inertia / arm.gravity.amplitude));
    for (const double time : {-reach, -0.3 * reach, 0.5 * reach, reach}) {
      JointState found;
      series->follow(time, {&found, 1});
      const PlaneState expected = integrated(system, extreme, from, time);
      EXPECT_NEAR(found.position, expected[0], 2e-15 * (1.0 + std::abs(expected[0]))) << time;
      EXPECT_NEAR(found.velocity, expected[1], 1e-14 * (1.0 + std::abs(expected[1]))) << time;
    }
  }
}

TEST(MotionSeries, IsTheMotionAsFarAsItReaches) {
  Dice dice(4);
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    Arm arm = pendulum(dice.between(1.0, 50.0), dice.between(5.0, 50.0), dice.between(20.0, 100.0));
    arm.gravity.phase = dice.between(-3.0, 3.0);
    if (dice.happens(0.3)) arm.viscous_friction = dice.between(0.0, 5.0);
    expect_the_motion(arm, {dice.between(-3.0, 3.0), dice.happens(0.3) ? 0.0 : dice.between(-3.0, 3.0)});
  }
}

/// In groups of every size, and a last one that is not full.
TEST(MotionSeries, SaysTheSameOfSeveralStatesAtOnce) {
  const SingleJointArm system(pendulum(39.0, 29.43, 60.0));
  const auto series = MotionSeries::about(system, Extreme::kHighest, {0.3, 0.4});
  ASSERT_TRUE(series);
  for (const double step : {-0.01, 0.01}) {
    for (std::size_t count = 1; count <= 27; ++count) {
      std::vector<JointState> states(count);
      series->follow(step, states);
      for (std::size_t i = 0; i < count; ++i) {
        JointState alone;
        series->follow(step * static_cast<double>(i + 1), {&alone, 1});
        EXPECT_EQ(states[i], alone) << i << " of " << count;
      }
    }
  }
}

TEST(MotionSeries, KnowsItsReachWhereMostTermsVanish) {
  expect_the_motion(pendulum(39.0, 29.43, 60.0), {0.5 * std::numbers::pi, 0.0});
  expect_the_motion(pendulum(39.0, 29.43, 60.0), {0.0, 0.0});
}

TEST(MotionSeries, IsNotKnownWhereTheTorqueHasBends) {
  Arm arm = pendulum(39.0, 29.43, 60.0);
  arm.torque = TorqueSpeedLine{60.0, 2.0};
  EXPECT_FALSE(MotionSeries::about(SingleJointArm(arm), Extreme::kHighest, {0.0, 0.5}));
  arm.torque = TorqueTable{{0.0, 1.0}, {0.0}, {{-60.0, 60.0}, {-50.0, 50.0}}};
  EXPECT_FALSE(MotionSeries::about(SingleJointArm(arm), Extreme::kHighest, {0.0, 0.5}));
}

}  // namespace
}  // namespace dualarm
