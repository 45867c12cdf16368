#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/phase_plane/portrait.h"
#include "tests/core/phase_plane/rig.h"

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(PortraitRounding, SeesATrapThatIsShorterThanAStep) {
  // Within 0.0073 rad of -pi/2 braking falls just short of holding the limit.
  const Rig system({-4.0, 1.0}, {-0.27, 0.27}, true, [](double s, double v) -> Interval {
    return {-1.0 - std::sin(s) + 1e-4 * v, 2.0};
  });
  const std::vector<JointState> upper = draw_portrait(system, {0.0, 0.0}, 5001).upper_limit;
  ASSERT_EQ(upper.size(), 5001u);
  EXPECT_EQ(upper[2400].velocity, 0.27);
  EXPECT_LT(upper[2425].velocity, 0.27);
  EXPECT_GT(upper[2425].velocity, 0.2699);
  EXPECT_EQ(upper[2450].velocity, 0.27);
}

TEST(PortraitRounding, GoesOnBelowAStandstillThatAnArcReachesOnlyInTheEnd) {
  for (const double friction : {0.01, 0.1, 0.3, 1.0, 3.0}) {
    SCOPED_TRACE(friction);
    // Braking holds the arm from -asin(0.8) on, and again below asin(0.8) - pi.
    const Rig system = pendulum(0.8, 1.0, 0.0, friction, {-6.0, 2.0}, {-0.1, 0.1});
    const std::vector<JointState> upper = draw_portrait(system, {1.0, 0.0}, 801).upper_limit;
    ASSERT_FALSE(upper.empty());
    EXPECT_EQ(upper.front().position, -6.0);
    double last_below = -6.0;
    for (const JointState& state : upper) {
      if (state.position < std::asin(0.8) - kPi + 1e-9) last_below = state.position;
    }
    EXPECT_NEAR(last_below, std::asin(0.8) - kPi, 0.01);
  }
}

}  // namespace
}  // namespace dualarm
