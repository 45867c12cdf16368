#include "core/coordination/start_times.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const IntervalSet kAll({{-kInfinity, kInfinity}});

TEST(BestStartTimes, StartTogetherWhereThatIsSafe) {
  const auto times = best_start_times(IntervalSet({{-1.0, 1.0}}), {2.0}, {3.0}, kInfinity);
  ASSERT_TRUE(times);
  EXPECT_EQ(times->first, 0.0);
  EXPECT_EQ(times->second, 0.0);
  EXPECT_EQ(times->duration, 3.0);
}

TEST(BestStartTimes, LetTheArmWaitThatHasSlack) {
  // Arm 2 is slower by 1 s: arm 1 may wait that long for nothing.
  const auto times = best_start_times(IntervalSet({{-kInfinity, -0.8}, {0.3, kInfinity}}), {2.0}, {3.0}, kInfinity);
  ASSERT_TRUE(times);
  EXPECT_EQ(times->first, 0.8);
  EXPECT_EQ(times->duration, 3.0);
}

TEST(BestStartTimes, TakeTheShorterOfTwoOrders) {
  const auto times = best_start_times(IntervalSet({{-kInfinity, -0.9}, {0.4, kInfinity}}), {2.0}, {2.0}, kInfinity);
  ASSERT_TRUE(times);
  EXPECT_EQ(times->second, 0.4);
  EXPECT_EQ(times->duration, 2.4);
}

TEST(BestStartTimes, KeepTheLargestDelayAllowed) {
  const IntervalSet safe({{-kInfinity, -0.9}, {0.4, kInfinity}});
  EXPECT_TRUE(best_start_times(safe, {2.0}, {2.0}, 0.4));
  EXPECT_FALSE(best_start_times(safe, {2.0}, {2.0}, 0.39));
}

TEST(BestStartTimes, AreNoneWhereEveryDelayCollides) {
  EXPECT_FALSE(best_start_times(IntervalSet(), {2.0}, {2.0}, kInfinity));
}

TEST(BestStartTimes, LetAnArmInMotionBeginAtOnce) {
  const IntervalSet safe({{-kInfinity, -0.4}, {0.9, kInfinity}});
  const auto times = best_start_times(safe, {2.0, false, true}, {2.0}, kInfinity);
  ASSERT_TRUE(times);
  EXPECT_EQ(times->first, 0.0);
  EXPECT_EQ(times->second, 0.9);
  EXPECT_FALSE(best_start_times(safe, {2.0, false, true}, {2.0, false, true}, kInfinity));
}

TEST(BestStartTimes, LetAnArmArriveInMotionAtTheEnd) {
  // Arm 1 takes 1 s and must not be early, arm 2 takes 3 s.
  const auto times = best_start_times(kAll, {1.0, true, false}, {3.0}, kInfinity);
  ASSERT_TRUE(times);
  EXPECT_EQ(times->first, 2.0);
  EXPECT_EQ(times->second, 0.0);
  EXPECT_EQ(times->duration, 3.0);
  // Where the end of both is the wrong moment, it arrives later still.
  const auto later =
      best_start_times(IntervalSet({{-kInfinity, -2.5}, {-1.5, kInfinity}}), {1.0, true, false}, {3.0}, kInfinity);
  ASSERT_TRUE(later);
  EXPECT_EQ(later->first, 2.5);
  EXPECT_EQ(later->duration, 3.5);
}

TEST(BestStartTimes, LetTwoArmsThatArriveInMotionArriveTogether) {
  const auto times = best_start_times(kAll, {1.0, true, false}, {3.0, true, false}, kInfinity);
  ASSERT_TRUE(times);
  EXPECT_EQ(times->first, 2.0);
  EXPECT_EQ(times->duration, 3.0);
  EXPECT_FALSE(best_start_times(IntervalSet({{-kInfinity, -2.1}, {-1.9, kInfinity}}), {1.0, true, false},
                                {3.0, true, false}, kInfinity));
}

TEST(BestStartTimes, AreNoneWhereAMotionWouldHaveToBeStretched) {
  EXPECT_FALSE(best_start_times(kAll, {1.0, false, false}, {3.0}, kInfinity));
  EXPECT_TRUE(possible_delays({1.0, false, false}, {3.0}).empty());
  EXPECT_TRUE(best_start_times(kAll, {3.0, false, false}, {1.0}, kInfinity));
}

TEST(BestStartTimes, TakeDurationsThatDifferByRoundingForTheSame) {
  const double longer = std::nextafter(2.0, 3.0);
  for (const auto& [first, second] : {std::pair(2.0, longer), std::pair(longer, 2.0)}) {
    const auto times = best_start_times(kAll, {first, false, false}, {second, false, false}, kInfinity);
    ASSERT_TRUE(times);
    EXPECT_EQ(times->first, 0.0);
    EXPECT_EQ(times->second, 0.0);
    EXPECT_EQ(times->duration, longer);
  }
}

/// Least duration over all pairs of start times on a grid, by the definition: each arm waits or begins at once, is
/// early or arrives at the end. Everything in whole steps, so that nothing is lost to rounding.
struct Brute {
  int first = 0;
  int second = 0;
  bool first_may_wait = true;
  bool first_may_be_early = true;
  bool second_may_wait = true;
  bool second_may_be_early = true;
  std::vector<std::pair<int, int>> safe;
  int longest_wait = 0;

  int best() const {
    int best = std::numeric_limits<int>::max();
    for (int t1 = 0; t1 <= (first_may_wait ? longest_wait : 0); ++t1) {
      for (int t2 = 0; t2 <= (second_may_wait ? longest_wait : 0); ++t2) {
        const int end = std::max(t1 + first, t2 + second);
        if (!first_may_be_early && t1 + first != end) continue;
        if (!second_may_be_early && t2 + second != end) continue;
        const bool is_safe = std::any_of(safe.begin(), safe.end(), [&](const auto& interval) {
          return interval.first <= t2 - t1 && t2 - t1 <= interval.second;
        });
        if (is_safe) best = std::min(best, end);
      }
    }
    return best;
  }
};

TEST(BestStartTimes, EqualABruteForceOverAllPairsOfStartTimes) {
  constexpr std::uint64_t kSeed = 3;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 generator(kSeed);
  const auto below = [&](int count) { return static_cast<int>(generator() % count); };
  int found = 0;
  int none = 0;
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(i);
    Brute brute;
    brute.first = below(30);
    brute.second = below(30);
    for (bool* flag :
         {&brute.first_may_wait, &brute.first_may_be_early, &brute.second_may_wait, &brute.second_may_be_early}) {
      *flag = below(3) > 0;
    }
    brute.longest_wait = below(60);
    std::vector<Interval> safe;
    for (int k = below(4); k >= 0; --k) {
      const int from = below(120) - 60;
      brute.safe.emplace_back(from, from + below(20));
      safe.push_back({static_cast<double>(brute.safe.back().first), static_cast<double>(brute.safe.back().second)});
    }
    const auto times = best_start_times(
        IntervalSet(safe), {static_cast<double>(brute.first), brute.first_may_wait, brute.first_may_be_early},
        {static_cast<double>(brute.second), brute.second_may_wait, brute.second_may_be_early}, brute.longest_wait);
    const int best = brute.best();
    ASSERT_EQ(times.has_value(), best != std::numeric_limits<int>::max());
    ++(times ? found : none);
    if (times) {
      EXPECT_EQ(times->duration, best);
    }
  }
  EXPECT_GT(found, 500);
  EXPECT_GT(none, 500);
}

TEST(BestStartTimes, WaitBothWhereMovingObjectsPassFirst) {
  const SafeStarts safe = {IntervalSet({{-kInfinity, -0.5}, {0.25, kInfinity}}), IntervalSet({{2.0, kInfinity}}),
                           IntervalSet({{0.0, 0.5}, {1.0, 1.25}, {5.0, 6.0}})};
  const auto times = best_start_times(safe, {2.0}, {2.0}, kInfinity);
  ASSERT_TRUE(times);
  EXPECT_EQ(times->first, 2.0);
  EXPECT_EQ(times->second, 0.0);
  EXPECT_EQ(times->duration, 4.0);
  EXPECT_FALSE(best_start_times(safe, {2.0}, {2.0}, 1.9));
  EXPECT_FALSE(best_start_times(safe, {2.0, false, true}, {2.0}, kInfinity));
}

TEST(BestStartTimes, WithMovingObjectsEqualABruteForceOverAllPairsOfStartTimes) {
  constexpr std::uint64_t kSeed = 4;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 generator(kSeed);
  const auto below = [&](int count) { return static_cast<int>(generator() % count); };
  const auto intervals = [&](int least) {
    std::vector<Interval> drawn;
    for (int k = below(4); k >= 0; --k) {
      const int from = least + below(60);
      drawn.push_back({static_cast<double>(from), static_cast<double>(from + below(15))});
    }
    return IntervalSet(drawn);
  };
  int found = 0;
  int none = 0;
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(i);
    const SafeStarts safe = {intervals(-30), intervals(-10), intervals(-10)};
    const Timing first = {static_cast<double>(below(30)), below(4) > 0, below(4) > 0};
    const Timing second = {static_cast<double>(below(30)), below(4) > 0, below(4) > 0};
    const int longest_wait = below(60);
    double best = kInfinity;
    double least_wait = kInfinity;
    for (int t1 = 0; t1 <= (first.may_wait ? longest_wait : 0); ++t1) {
      for (int t2 = 0; t2 <= (second.may_wait ? longest_wait : 0); ++t2) {
        const double end = std::max(t1 + first.duration, t2 + second.duration);
        if (!first.may_be_early && t1 + first.duration != end) continue;
        if (!second.may_be_early && t2 + second.duration != end) continue;
        if (!safe.first.contains(t1) || !safe.second.contains(t2) || !safe.delays.contains(t2 - t1)) continue;
        if (end > best) continue;
        least_wait = end < best ? t1 + t2 : std::min<double>(least_wait, t1 + t2);
        best = end;
      }
    }
    const auto times = best_start_times(safe, first, second, longest_wait);
    ASSERT_EQ(times.has_value(), best < kInfinity);
    ++(times ? found : none);
    if (!times) continue;
    EXPECT_EQ(times->duration, best);
    EXPECT_EQ(times->first + times->second, least_wait);
    EXPECT_TRUE(safe.first.contains(times->first) && safe.second.contains(times->second));
  }
  EXPECT_GT(found, 500);
  EXPECT_GT(none, 500);
}

}  // namespace
}  // namespace dualarm
