#include "core/verification/peak.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Share, BySideComparesWithTheLimitOfThatSide) {
  const Share share = Share::by_side({-2.0, 4.0});
  EXPECT_DOUBLE_EQ(share.of(2.0), 0.5);
  EXPECT_DOUBLE_EQ(share.of(-2.0), 1.0);
  EXPECT_DOUBLE_EQ(share.of(-3.0), 1.0 + 1.0 / 3.0) << "outside, half the width counts";
  EXPECT_DOUBLE_EQ(share.of(0.0), 0.0);
}

TEST(Share, NothingIsUsedOfAnInfiniteLimit) {
  const Share share = Share::by_side({-kInfinity, kInfinity});
  EXPECT_EQ(share.of(1e6), 0.0);
  EXPECT_EQ(share.of(-1e6), 0.0);
}

TEST(Share, LimitsWithoutZeroAreJudgedFromTheirMiddle) {
  const Share share = Share::by_side({2.0, 6.0});
  EXPECT_DOUBLE_EQ(share.of(4.0), 0.0);
  EXPECT_DOUBLE_EQ(share.of(2.0), 1.0);
  EXPECT_DOUBLE_EQ(share.of(6.0), 1.0);
  EXPECT_DOUBLE_EQ(share.of(0.0), 2.0);
}

TEST(Share, ASideOfNextToNothingDoesNotMagnifyRounding) {
  for (const double lower : {0.0, -1e-300, -1e-9}) {
    SCOPED_TRACE(lower);
    const Share share = Share::by_side({lower, 60.0});
    EXPECT_NEAR(share.of(lower - 9e-16), 1.0, 1e-15);
    EXPECT_NEAR(share.of(lower - 0.3), 1.01, 1e-9);
    EXPECT_DOUBLE_EQ(share.of(30.0), 0.5);
    EXPECT_EQ(share.of(0.0), 0.0);
  }
}

TEST(Share, OneInfiniteSideDoesNotExcuseTheOther) {
  EXPECT_DOUBLE_EQ(Share::by_side({-1.0, kInfinity}).of(-5.0), 5.0);
  EXPECT_DOUBLE_EQ(Share::by_side({-kInfinity, 2.0}).of(3.0), 1.5);
  EXPECT_GT(Share::by_side({0.0, kInfinity}).of(-0.1), 1.01);
}

TEST(Share, FromMiddleIsOneAtBothEnds) {
  const Share share = Share::from_middle({-1.0, 5.0});
  EXPECT_DOUBLE_EQ(share.of(-1.0), 1.0);
  EXPECT_DOUBLE_EQ(share.of(5.0), 1.0);
  EXPECT_DOUBLE_EQ(share.of(2.0), 0.0);
}

TEST(Share, WhatIsNotANumberUsesMoreThanAnyLimit) {
  EXPECT_EQ(Share::from_middle({-1.0, 1.0}).of(std::numeric_limits<double>::quiet_NaN()), kInfinity);
}

TEST(Share, ValuesWithinAShareUseNoMore) {
  const std::array<Share, 5> shares = {Share::by_side({-2.0, 4.0}), Share::by_side({2.0, 6.0}),
                                       Share::by_side({-kInfinity, 3.0}), Share::by_side({0.0, 60.0}),
                                       Share::from_middle({-1.0, 5.0})};
  for (const Share& share : shares) {
    for (const double used : {0.0, 0.25, 1.0, 1.5, 7.0}) {
      const Interval values = share.values_within(used);
      for (const double end : {values.lower, values.upper}) {
        if (!std::isfinite(end)) continue;
        EXPECT_LE(share.of(end), used + 1e-15);
        const double outwards = end == values.upper ? 1e-6 : -1e-6;
        EXPECT_GT(share.of(end + outwards), used);
      }
    }
    EXPECT_TRUE(share.values_within(-1.0).empty());
    EXPECT_EQ(share.values_within(kInfinity), (Interval{-kInfinity, kInfinity}));
  }
}

TEST(PeakSearch, BelievesARangeOnlyWhereItIsCloseToWhatIsAttained) {
  PeakSearch search(Share::by_side({-1.0, 2.0}), 1e-3);
  EXPECT_FALSE(search.visit_range({0.0, 0.5}, 0.0)) << "nothing is attained yet";
  search.visit(0.0, 1.0);
  EXPECT_TRUE(search.visit_range({-0.2, 1.001}, 0.0));
  EXPECT_DOUBLE_EQ(search.proven(), 0.5005);
  EXPECT_FALSE(search.visit_range({-0.2, 1.003}, 0.0));
  EXPECT_FALSE(search.visit_range({-0.502, 0.0}, 0.0));
  EXPECT_TRUE(search.visit_range({-0.2, 1.003}, 0.002)) << "rounding is forgiven";
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(search.visit_range({nothing, 0.0}, 0.0));
  EXPECT_FALSE(search.visit_range({0.0, nothing}, 1.0));
}

TEST(PeakSearch, ProvesThePeakOfASineWithinItsSlack) {
  PeakSearch search(Share::from_middle({-1.0, 1.0}), 1e-8);
  const Quantity sine = {[](double t) { return std::sin(t); }, [](Interval) { return 1.0; }, 0.0};
  search.visit(sine, {0.0, 3.0});
  EXPECT_GE(search.proven(), 1.0);
  EXPECT_LE(search.proven(), 1.0 + 1e-8);
  EXPECT_NEAR(search.time(), std::acos(0.0), 1e-3);
  EXPECT_NEAR(search.value(), 1.0, 1e-7);
}

TEST(PeakSearch, FindsAPeakBetweenTheEndsOfAnInterval) {
  PeakSearch search(Share::from_middle({-1.0, 1.0}), 1e-6);
  const Quantity bump = {[](double t) { return 8.0 * t * (1.0 - t); }, [](Interval) { return 16.0; }, 0.0};
  search.visit(bump, {0.0, 1.0});
  EXPECT_NEAR(search.proven(), 2.0, 1e-5);
}

TEST(PeakSearch, ForgivesRounding) {
  PeakSearch search(Share::from_middle({-1.0, 1.0}), 1e-6);
  const Quantity noisy = {[](double) { return 1.0 + 1e-4; }, [](Interval) { return 0.0; }, 1e-4};
  search.visit(noisy, {0.0, 1.0});
  EXPECT_NEAR(search.proven(), 1.0, 1e-12);
}

TEST(PeakSearch, AQuantityThatIsNoNumberIsBeyondEveryLimit) {
  PeakSearch search(Share::from_middle({-1.0, 1.0}), 1e-6);
  const Quantity nothing = {[](double) { return std::numeric_limits<double>::quiet_NaN(); },
                            [](Interval) { return 0.0; }, 0.0};
  search.visit(nothing, {0.0, 1.0});
  EXPECT_EQ(search.proven(), kInfinity);
}

}  // namespace
}  // namespace dualarm
