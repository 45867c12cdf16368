#include "core/verification/peak.h"

#include <gtest/gtest.h>

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
