#include "core/phase_plane/integral_series.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"
#include "tests/core/phase_plane/test_arms.h"
#include "tests/support/dice.h"

namespace dualarm {
namespace {

TEST(IntegralSeries, TellsTheIntegralToRounding) {
  const auto series = IntegralSeries::of([](double x) { return std::cos(x) + 1.0 / (2.0 + x); }, -0.5, 1.5);
  ASSERT_TRUE(series);
  for (int i = 0; i <= 100; ++i) {
    const double x = -0.5 + 2.0 * i / 100.0;
    EXPECT_NEAR(series->up_to(x), std::sin(x) - std::sin(-0.5) + std::log((2.0 + x) / 1.5), 3e-15) << x;
  }
}

TEST(IntegralSeries, IsNotMadeOfWhatItCannotTell) {
  EXPECT_FALSE(IntegralSeries::of([](double x) { return std::abs(x - 0.3); }, 0.0, 1.0));
  EXPECT_FALSE(IntegralSeries::of([](double x) { return 1.0 / (x + 1e-3); }, 0.0, 1.0));
  EXPECT_FALSE(IntegralSeries::of([](double) { return std::nan(""); }, 0.0, 1.0));
}

TEST(IntegralSeries, LeavesTheTimesOfAProfileAsTheyAre) {
  Dice dice(5);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    Arm arm = pendulum(dice.between(1.0, 50.0), dice.between(5.0, 50.0), dice.between(20.0, 100.0));
    arm.gravity.phase = dice.between(-3.0, 3.0);
    if (dice.happens(0.5)) arm.velocity = {-1.2, 1.2};
    const SingleJointArm system(arm);
    const JointState start = {dice.between(-2.0, 2.0), dice.happens(0.5) ? 0.0 : dice.between(-1.0, 1.0)};
    const JointState goal = {dice.between(-2.0, 2.0), dice.happens(0.5) ? 0.0 : dice.between(-1.0, 1.0)};
    const auto found = fastest_motion(system, start, goal, Swings::kSkip);
    if (std::holds_alternative<Blocked>(found)) continue;
    const Profile& plain = std::get<FastestMotion>(found).profile;
    const Profile prepared = plain.asked_often();
    for (std::size_t leg = 0; leg < plain.legs().size(); ++leg) {
      const Leg& way = plain.legs()[leg];
      for (const double share : {0.0, 1e-12, 1e-6, 0.1, 0.5, 0.9, 1.0 - 1e-6, 1.0}) {
        const double position = std::lerp(way.start, way.goal, share);
        EXPECT_NEAR(prepared.time_at(prepared.legs()[leg], position), plain.time_at(way, position),
                    1e-13 * plain.duration())
            << share;
      }
    }
  }
}

}  // namespace
}  // namespace dualarm
