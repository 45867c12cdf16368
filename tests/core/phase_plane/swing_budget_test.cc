#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/phase_plane/metered_system.h"
#include "core/phase_plane/swing.h"
#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"
#include "tests/core/phase_plane/test_arms.h"

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;
const Budget kOver(Budget::Clock::now());

TEST(SwingSearch, IsOverWithTheBudgetAndClaimsNothing) {
  // theory.md, section 1.3: only a swing lifts this arm.
  const SingleJointArm system(pendulum(1.0, 1.0, 0.6));
  ASSERT_TRUE(std::holds_alternative<FastestMotion>(fastest_motion(system, 0.0, kPi)));
  const auto motion = fastest_motion(system, 0.0, kPi, Swings::kSearch, kOver);
  ASSERT_TRUE(std::holds_alternative<Blocked>(motion));
  const auto& blocked = std::get<Blocked>(motion);
  EXPECT_FALSE(blocked.is_proven);
  EXPECT_FALSE(blocked.is_searched_out);
  EXPECT_FALSE(finds_swing(system, {0.0, 0.0}, {kPi, 0.0}, kOver));
  EXPECT_TRUE(finds_swing(system, {0.0, 0.0}, {kPi, 0.0}, Budget()));
}

TEST(SwingSearch, LeavesTheMonotoneMotionWhereTheBudgetIsOver) {
  const SingleJointArm system(pendulum(1.0, 1.0, 0.76));
  const auto motion = fastest_motion(system, 0.0, kPi, Swings::kSearch, kOver);
  ASSERT_TRUE(std::holds_alternative<FastestMotion>(motion));
  const auto& monotone = std::get<FastestMotion>(motion);
  EXPECT_NEAR(monotone.profile.duration(), 6.191, 5e-4);
  EXPECT_EQ(monotone.minimum_over, MinimumOver::kMonotoneMotions);
  EXPECT_LT(monotone.lower_bound, 5.790);
}

TEST(SwingSearch, GivesWhatItHasFoundWhenItIsCancelled) {
  const SingleJointArm arm(pendulum(1.0, 1.0, 0.6));
  double before = HUGE_VAL;
  for (const int polls : {0, 30, 100, 300, 1000, 3000, 100'000'000}) {
    SCOPED_TRACE(polls);
    const MeteredSystem system(arm);
    int asked = 0;
    long when_over = 0;
    const Budget budget(Budget::Clock::time_point::max(), [&] {
      if (++asked == polls + 1) when_over = system.count();
      return asked > polls;
    });
    const auto swing = fastest_swing(system, {0.0, 0.0}, {kPi, 0.0}, HUGE_VAL, budget);
    const double duration = swing ? swing->duration() : HUGE_VAL;
    EXPECT_LE(duration, before * (1.0 + 1e-9));
    before = duration;
    const long after = asked > polls ? system.count() - when_over : 0;
    EXPECT_LT(after, 2000) << "goes on after it is cancelled";
  }
  EXPECT_NEAR(before, 6.696, 5e-4);
}

}  // namespace
}  // namespace dualarm
