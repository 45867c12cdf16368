#include "core/coordination/least_value.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "tests/support/dice.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kEnough = 1e-14;
/// Looks that a golden section needs to come as near as rounding.
constexpr int kSectionLooks = 75;

struct Search {
  double least;
  int looks;
};

Search search(const std::function<double(double)>& function, double left, double right) {
  int looks = 0;
  const auto counted = [&](double position) {
    ++looks;
    return function(position);
  };
  const double middle = 0.5 * (left + right);
  const std::array<Looked, 3> known = {{{left, function(left)}, {middle, function(middle)}, {right, function(right)}}};
  return {least_value(counted, known, kEnough), looks};
}

TEST(LeastValue, OfSmoothMinimaTakesAFewLooks) {
  Dice dice(1);
  for (int i = 0; i < 200; ++i) {
    const double at = dice.between(0.71, 0.74);
    const double bend = std::exp(dice.between(-3.0, 3.0));
    const auto function = [&](double x) { return std::exp(bend * (x - at)) - bend * (x - at); };
    const Search found = search(function, 0.7, 0.75);
    EXPECT_NEAR(found.least, 1.0, 1e-13) << at << " " << bend;
    EXPECT_LT(found.looks, 30) << at << " " << bend;
  }
}

TEST(LeastValue, OfCornersTakesAFewLooks) {
  Dice dice(2);
  for (int i = 0; i < 200; ++i) {
    const double at = dice.between(0.7, 0.75);
    const double fall = std::exp(dice.between(-3.0, 3.0));
    const double rise = std::exp(dice.between(-3.0, 3.0));
    const double bend = dice.between(-2.0, 2.0);
    const auto function = [&](double x) {
      const double way = x - at;
      return (way < 0.0 ? -fall : rise) * way + 0.1 * bend * way * way;
    };
    const Search found = search(function, 0.7, 0.75);
    EXPECT_NEAR(found.least, 0.0, 1e-13) << at << " " << fall << " " << rise << " " << bend;
    EXPECT_LT(found.looks, 50) << at << " " << fall << " " << rise << " " << bend;
  }
}

TEST(LeastValue, IsTheLimitWhereTheFunctionEnds) {
  Dice dice(3);
  for (int i = 0; i < 200; ++i) {
    const double end = dice.between(0.7, 0.75);
    const double fall = std::exp(dice.between(-3.0, 3.0));
    const auto function = [&](double x) { return x > end ? kInfinity : fall * (end - x); };
    const Search found = search(function, 0.7, 0.75);
    EXPECT_NEAR(found.least, 0.0, 1e-13) << end << " " << fall;
    EXPECT_LT(found.looks, kSectionLooks) << end << " " << fall;
  }
}

TEST(LeastValue, MayLieAtAnEnd) {
  EXPECT_EQ(search([](double x) { return std::exp(x); }, 0.7, 0.75).least, std::exp(0.7));
  EXPECT_EQ(search([](double x) { return -std::sqrt(x); }, 0.7, 0.75).least, -std::sqrt(0.75));
}

TEST(LeastValue, IsTheSameForPositionsInEitherOrder) {
  const auto function = [](double x) { return std::abs(x - 0.72) + x * x; };
  EXPECT_NEAR(search(function, 0.75, 0.7).least, search(function, 0.7, 0.75).least, 1e-15);
}

TEST(LeastValue, IsInfiniteWhereNothingIsDefined) {
  EXPECT_EQ(search([](double) { return kInfinity; }, 0.7, 0.75).least, kInfinity);
}

}  // namespace
}  // namespace dualarm
