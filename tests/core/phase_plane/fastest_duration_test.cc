#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"
#include "tests/core/phase_plane/test_arms.h"

namespace dualarm {
namespace {

TEST(FastestDuration, IsThatOfTheFastestMotionBetweenAnyTwoStates) {
  constexpr unsigned kSeed = 23;
  SCOPED_TRACE(kSeed);
  std::mt19937 random(kSeed);
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  int blocked = 0;
  for (int round = 0; round < 1000; ++round) {
    Arm arm = pendulum(draw(0.1, 50.0), draw(0.0, 40.0), draw(1.0, 80.0));
    arm.joint_range = {-3.2, 3.2};
    arm.velocity = {-4.0, 4.0};
    const SingleJointArm system(arm);
    const JointState start = {draw(-3.0, 3.0), round % 2 == 0 ? 0.0 : draw(-4.0, 4.0)};
    const JointState goal = {draw(-3.0, 3.0), round % 3 == 0 ? 0.0 : draw(-4.0, 4.0)};
    const auto motion = fastest_motion(system, start, goal, Swings::kSkip);
    const double duration = fastest_duration(system, start, goal);
    const auto* found = std::get_if<FastestMotion>(&motion);
    ASSERT_EQ(std::isfinite(duration), found != nullptr) << "round " << round;
    if (found == nullptr) {
      ++blocked;
    } else {
      ASSERT_NEAR(duration, found->profile.duration(), 1e-12 * duration) << "round " << round;
    }
  }
  EXPECT_GT(blocked, 50);
  EXPECT_LT(blocked, 950);
}

}  // namespace
}  // namespace dualarm
