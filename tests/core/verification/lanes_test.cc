#include "core/verification/lanes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace dualarm {
namespace {

constexpr std::size_t kMostNumbers = 11;

/// Products next to sums, which a processor may fuse, a division, and choices.
template <typename Number>
[[gnu::always_inline]] inline Number formula(const Number& a, const Number& b) {
  const Number sum = a * b + a;
  return greater<Number>(lesser<Number>(sum / (b + 3.0), a), magnitude<Number>(b * b - a));
}

[[gnu::always_inline]] inline void fill(const std::vector<double>& a, const std::vector<double>& b,
                                        std::vector<double>& results) {
  visit_lanes(
      a.size(), [&]<typename Number>(std::size_t i) __attribute__((always_inline)) {
        store<Number>(&results[i], formula<Number>(load<Number>(&a[i]), load<Number>(&b[i])));
      });
}

TEST(Lanes, EveryNumberIsVisited) {
  for (std::size_t count = 0; count <= kMostNumbers; ++count) {
    std::set<std::size_t> visited;
    visit_lanes(count, [&]<typename Number>(std::size_t i) {
      for (std::size_t k = 0; k < sizeof(Number) / sizeof(double); ++k) visited.insert(i + k);
    });
    ASSERT_EQ(visited.size(), count);
    if (count > 0) {
      EXPECT_EQ(*visited.rbegin(), count - 1);
    }
  }
}

TEST(Lanes, NumbersAreThoseOfOneAtATimeToTheLastDigitOnAnyProcessor) {
  constexpr unsigned kSeed = 20261201;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> any(-2.0, 2.0);
  for (std::size_t count = 1; count <= kMostNumbers; ++count) {
    std::vector<double> a(count), b(count), alone(count), plainly(count), widely(count);
    for (std::size_t i = 0; i < count; ++i) {
      a[i] = any(random);
      b[i] = any(random);
      alone[i] = formula<double>(a[i], b[i]);
    }
    fill(a, b, plainly);
    with_wide_registers([&] { fill(a, b, widely); });
    EXPECT_EQ(plainly, alone);
    EXPECT_EQ(widely, alone);
  }
}

TEST(Lanes, WhatIsNoNumberBecomesInfinite) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const Lanes mixed = or_infinite<Lanes>(Lanes{1.0, kNone, -2.0, kNone});
  EXPECT_EQ(mixed[0], 1.0);
  EXPECT_TRUE(std::isinf(mixed[1]));
  EXPECT_EQ(mixed[2], -2.0);
  EXPECT_TRUE(std::isinf(mixed[3]));
}

TEST(Lanes, TheLeastTheMostAndTheSumAreOfAllFour) {
  for (std::size_t place = 0; place < kLaneCount; ++place) {
    Lanes lanes = {1.0, 1.0, 1.0, 1.0};
    lanes[place] = -7.0;
    EXPECT_EQ(least_of(lanes), -7.0);
    EXPECT_EQ(sum_of(lanes), -4.0);
    lanes[place] = 7.0;
    EXPECT_EQ(most_of(lanes), 7.0);
  }
}

}  // namespace
}  // namespace dualarm
