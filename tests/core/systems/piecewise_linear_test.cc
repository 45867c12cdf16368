#include "core/systems/piecewise_linear.h"

#include <gtest/gtest.h>

#include <random>

namespace dualarm {
namespace {

const PiecewiseLinear kHat({-1.0, 0.0, 2.0}, {1.0, 3.0, -1.0});

TEST(PiecewiseLinear, IsConstantWithOneKnot) {
  const PiecewiseLinear one({4.0}, {2.5});
  EXPECT_TRUE(one.is_constant());
  EXPECT_EQ(one.integral(1.0, -2.0), -5.0);
  EXPECT_TRUE(one.bends({-10.0, 10.0}).empty());
}

TEST(PiecewiseLinear, ListsItsBends) {
  EXPECT_EQ(kHat.bends({-5.0, 5.0}), (std::vector{-1.0, 0.0, 2.0}));
  EXPECT_EQ(kHat.bends({-1.0, 0.0}), (std::vector{-1.0, 0.0}));
  EXPECT_TRUE(kHat.bends({0.5, 1.5}).empty());
}

TEST(PiecewiseLinear, FallsAsSteeplyAsItsSteepestPiece) {
  EXPECT_EQ(kHat.steepest_fall(), 2.0);
  EXPECT_EQ(PiecewiseLinear({0.0, 1.0}, {0.0, 5.0}).steepest_fall(), 0.0);
}

TEST(PiecewiseLinear, IntegratesAcrossItsBendsInBothDirections) {
  // One before the first bend, two of the first ramp, two of the second, minus one behind.
  EXPECT_DOUBLE_EQ(kHat.integral(-2.0, 5.0), 1.0 + 2.0 + 2.0 - 1.0);
  EXPECT_DOUBLE_EQ(kHat.integral(3.0, -5.0), -4.0);
  EXPECT_DOUBLE_EQ(kHat.integral(-1.0, 1.0), 2.0);
  EXPECT_DOUBLE_EQ(kHat.integral(0.0, -1.0), -2.0);
  EXPECT_DOUBLE_EQ(kHat.integral(2.0, -2.0), -2.0);
  EXPECT_EQ(kHat.integral(0.0, 0.0), 0.0);
}

TEST(PiecewiseLinear, IntegratesSmallChangesToTheirLastDigits) {
  EXPECT_DOUBLE_EQ(kHat.integral(0.0, 1e-20), 3e-20);
  EXPECT_DOUBLE_EQ(kHat.integral(0.0, -1e-20), -3e-20);
  EXPECT_DOUBLE_EQ(kHat.integral(2.0, 1e-20), -1e-20);
  // Across a bend that is 1e-17 rad ahead.
  EXPECT_DOUBLE_EQ(kHat.integral(-1e-17, 3e-17), 9e-17);
}

TEST(PiecewiseLinear, AddsUpIntegrals) {
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> draw(-3.0, 3.0);
    const double from = draw(random);
    const double first = draw(random);
    const double second = draw(random);
    EXPECT_NEAR(kHat.integral(from, first) + kHat.integral(from + first, second), kHat.integral(from, first + second),
                1e-14);
  }
}

}  // namespace
}  // namespace dualarm
