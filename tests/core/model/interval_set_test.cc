#include "core/model/interval_set.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
using Intervals = std::vector<Interval>;

TEST(IntervalSet, JoinsWhatOverlapsOrTouchesAndDropsWhatIsEmpty) {
  const IntervalSet set({{4, 5}, {1, 2}, {2, 3}, {9, 8}, {4.5, 6}});
  EXPECT_EQ(set.intervals(), (Intervals{{1, 3}, {4, 6}}));
}

TEST(IntervalSet, KnowsItsEndsFromItsInside) {
  const IntervalSet set({{1, 2}});
  EXPECT_TRUE(set.contains(1.0));
  EXPECT_FALSE(set.contains_inside(1.0));
  EXPECT_TRUE(set.contains_inside(1.5));
  EXPECT_FALSE(set.contains(2.5));
}

TEST(IntervalSet, CoversOnlyWhatOneIntervalCovers) {
  const IntervalSet set({{0, 1}, {2, 3}});
  EXPECT_TRUE(set.covers({0.2, 1.0}));
  EXPECT_FALSE(set.covers({0.5, 2.5}));
}

TEST(IntervalSet, CoversEachEndToATolerance) {
  const IntervalSet set({{0, 1}, {1.05, 3}});
  EXPECT_TRUE(set.covers({-0.1, 1.04}, 0.1));
  EXPECT_FALSE(set.covers({-0.2, 0.5}, 0.1));
  EXPECT_FALSE(set.covers({0.5, 2.0}, 0.1));  // two intervals, each a part of it
  EXPECT_TRUE(set.covers({1.0, 3.05}, 0.1));
}

TEST(IntervalSet, ComplementKeepsTheEndsAsSafe) {
  const IntervalSet gaps = IntervalSet({{-kInfinity, 0}, {1, 2}}).complement({-kInfinity, kInfinity});
  EXPECT_EQ(gaps.intervals(), (Intervals{{0, 1}, {2, kInfinity}}));
}

TEST(IntervalSet, ComplementOfTheWholeLineIsEmpty) {
  EXPECT_TRUE(IntervalSet({{-kInfinity, kInfinity}}).complement({-kInfinity, kInfinity}).empty());
}

TEST(IntervalSet, ComplementOfNothingIsTheWholeLine) {
  EXPECT_EQ(IntervalSet().complement({-kInfinity, kInfinity}).intervals(), (Intervals{{-kInfinity, kInfinity}}));
}

TEST(IntervalSet, ComplementAndSetShareNoInteriorPointAndMissNone) {
  constexpr unsigned kSeed = 7;
  SCOPED_TRACE(kSeed);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> end(-5.0, 5.0);
  for (int round = 0; round < 500; ++round) {
    Intervals intervals;
    for (int i = 0; i < 6; ++i) intervals.push_back({end(random), end(random)});
    const IntervalSet set(intervals);
    const IntervalSet rest = set.complement({-5.0, 5.0});
    for (int i = 0; i < 50; ++i) {
      const double value = end(random);
      ASSERT_NE(set.contains_inside(value), rest.contains_inside(value)) << value;
    }
  }
}

TEST(IntervalSet, UnionHoldsBoth) {
  EXPECT_EQ(unite(IntervalSet({{0, 1}}), IntervalSet({{0.5, 2}, {3, 4}})).intervals(), (Intervals{{0, 2}, {3, 4}}));
}

TEST(IntervalSet, UnitesAcrossNarrowGapsOnly) {
  EXPECT_EQ(unite_across({{3.0, 4.0}, {0.0, 1.0}, {1.5, 2.0}}, 0.5).intervals(),
            (std::vector<Interval>{{0.0, 2.0}, {3.0, 4.0}}));
  EXPECT_TRUE(unite_across({}, 0.5).empty());
}

}  // namespace
}  // namespace dualarm
