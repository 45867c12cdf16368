#include "core/coordination/start_times.h"

#include <gtest/gtest.h>

#include <limits>

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(BestStartTimes, StartTogetherWhereThatIsSafe) {
  const auto times = best_start_times(IntervalSet({{-1.0, 1.0}}), 2.0, 3.0, kInfinity);
  ASSERT_TRUE(times);
  EXPECT_EQ(times->first, 0.0);
  EXPECT_EQ(times->second, 0.0);
  EXPECT_EQ(times->duration, 3.0);
}

TEST(BestStartTimes, LetTheArmWaitThatHasSlack) {
  // Arm 2 is slower by 1 s: arm 1 may wait that long for nothing.
  const auto times = best_start_times(IntervalSet({{-kInfinity, -0.8}, {0.3, kInfinity}}), 2.0, 3.0, kInfinity);
  ASSERT_TRUE(times);
  EXPECT_EQ(times->first, 0.8);
  EXPECT_EQ(times->duration, 3.0);
}

TEST(BestStartTimes, TakeTheShorterOfTwoOrders) {
  const auto times = best_start_times(IntervalSet({{-kInfinity, -0.9}, {0.4, kInfinity}}), 2.0, 2.0, kInfinity);
  ASSERT_TRUE(times);
  EXPECT_EQ(times->second, 0.4);
  EXPECT_EQ(times->duration, 2.4);
}

TEST(BestStartTimes, KeepTheLargestDelayAllowed) {
  const IntervalSet safe({{-kInfinity, -0.9}, {0.4, kInfinity}});
  EXPECT_TRUE(best_start_times(safe, 2.0, 2.0, 0.4));
  EXPECT_FALSE(best_start_times(safe, 2.0, 2.0, 0.39));
}

TEST(BestStartTimes, AreNoneWhereEveryDelayCollides) {
  EXPECT_FALSE(best_start_times(IntervalSet(), 2.0, 2.0, kInfinity));
}

}  // namespace
}  // namespace dualarm
