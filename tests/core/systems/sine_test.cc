#include "core/systems/sine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/dice.h"

namespace dualarm {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

void expect_sine_and_cosine(double angle) {
  const long double exact_sine = std::sin(static_cast<long double>(angle));
  const long double exact_cosine = std::cos(static_cast<long double>(angle));
  const double floor = 1e-25 * std::abs(angle);
  const SineCosine both = sine_cosine(angle);
  EXPECT_NEAR(static_cast<double>(sine(angle) - exact_sine), 0.0,
              kEpsilon * static_cast<double>(std::abs(exact_sine)) + floor)
      << angle;
  EXPECT_NEAR(static_cast<double>(both.cosine - exact_cosine), 0.0,
              kEpsilon * static_cast<double>(std::abs(exact_cosine)) + floor)
      << angle;
  EXPECT_EQ(both.sine, sine(angle)) << angle;
}

TEST(Sine, IsTheSineToTheLastPlace) {
  Dice dice(6);
  for (const double most : {1e-8, 1.0, 10.0, 1e4, 1e6, 1e9}) {
    for (int i = 0; i < 100000; ++i) expect_sine_and_cosine(dice.between(-most, most));
  }
}

TEST(Sine, KeepsItsDigitsNearItsZeros) {
  for (int quarters = -40; quarters <= 40; ++quarters) {
    const double angle = quarters * (0.5 * std::numbers::pi);
    for (const double beside : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, -1e-12, -1e-6}) expect_sine_and_cosine(angle + beside);
  }
}

TEST(Sine, OfWhatIsNoAngleIsNoNumber) {
  EXPECT_TRUE(std::isnan(sine(std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(std::isnan(sine(std::nan(""))));
  EXPECT_EQ(sine(0.0), 0.0);
  EXPECT_EQ(sine_cosine(0.0).cosine, 1.0);
}

}  // namespace
}  // namespace dualarm
