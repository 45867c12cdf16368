#include "core/passage/climb.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dualarm {
namespace {

constexpr ClimbRules kRules = {1e-2, 1e-9, 1e-12};

struct Climbed {
  bool has_slopes = false;
  double best = -1e9;
  double position = 0.0;
  int looks = 0;
};

/// Climbs a function (position -> Rated, nothing outside [0, 1]) from a position.
template <class Function>
Climbed climbed(const Function& function, double from) {
  Climbed result;
  const auto rate = [&](double position) -> std::optional<Rated> {
    ++result.looks;
    if (position < 0.0 || position > 1.0) return std::nullopt;
    const Rated rated = function(position);
    if (rated.value > result.best) {
      result.best = rated.value;
      result.position = position;
    }
    return rated;
  };
  result.has_slopes = climb(rate, {-1.0, 3.0}, rate(from), kRules);
  return result;
}

TEST(Climb, FindsASmoothMaximumInAFewLooks) {
  const auto hill = [](double x) { return Rated{x, 2.0 + std::sin(2.0 * x), 2.0 * std::cos(2.0 * x)}; };
  for (const double from : {0.0, 0.3, 0.78, 1.0}) {
    const Climbed found = climbed(hill, from);
    EXPECT_TRUE(found.has_slopes);
    EXPECT_NEAR(found.best, 3.0, 1e-11);
    EXPECT_LE(found.looks, 16);
  }
}

TEST(Climb, FindsACornerInAFewLooks) {
  const double corner = 0.6180339;
  const auto roof = [&](double x) {
    return x < corner ? Rated{x, 1.0 + x - x * x / 10.0, 1.0 - x / 5.0}
                      : Rated{x, 1.0 + corner - corner * corner / 10.0 - 3.0 * (x * x - corner * corner), -6.0 * x};
  };
  for (const double from : {0.0, 0.4, 0.61803, 0.9}) {
    const Climbed found = climbed(roof, from);
    EXPECT_TRUE(found.has_slopes);
    EXPECT_NEAR(found.position, corner, 1e-9);
    EXPECT_LE(found.looks, 16);
  }
}

TEST(Climb, StopsWhereTheFunctionEnds) {
  const Climbed found = climbed([](double x) { return Rated{x, 1.0 + x, 1.0}; }, 0.5);
  EXPECT_TRUE(found.has_slopes);
  EXPECT_NEAR(found.position, 1.0, 1e-8);
}

TEST(Climb, SaysThatThereIsNoSlope) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(climbed([&](double x) { return Rated{x, 1.0, infinity}; }, 0.5).has_slopes);
  EXPECT_FALSE(climbed([](double x) { return Rated{x, 1.0, 1.0}; }, 2.0).has_slopes);
}

}  // namespace
}  // namespace dualarm
