#include "core/systems/balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dualarm {
namespace {

const GravityTorque kWeightless = {0.0, 0.0};
const GravityTorque kHanging = {1.0, 0.0};

/// Sign changes of the surplus, by steps of `step` rad.
int count_sign_changes(const PiecewiseLinear& torque, const GravityTorque& gravity, Interval within, double step) {
  int count = 0;
  double before = 0.0;
  auto piece = torque.pieces().begin();
  for (double s = within.lower; s <= within.upper; s += step) {
    while (s > piece->to) ++piece;
    const double here = piece->at(s) - gravity.amplitude * std::sin(s - gravity.phase);
    if (here * before < 0.0) ++count;
    before = here;
  }
  return count;
}

TEST(Balance, RepeatsEveryTurnUnderOneTorque) {
  const std::vector<double> positions = balances(0.5, kHanging, {-1000.0, 1000.0});
  EXPECT_EQ(positions.size(), 637U);  // 30 and 150 degrees, every turn
  for (const double s : positions) EXPECT_NEAR(std::sin(s), 0.5, 1e-12);
  EXPECT_TRUE(std::is_sorted(positions.begin(), positions.end()));
}

TEST(Balance, HasNoSignChangeWhereTheTorqueIsJustGravitysPeak) {
  EXPECT_TRUE(balances(1.0, kHanging, {-10.0, 10.0}).empty());
  EXPECT_TRUE(balances(0.0, kWeightless, {-10.0, 10.0}).empty());
}

TEST(Balance, IsFoundOnALongRamp) {
  const PiecewiseLinear ramp({-1000.0, 1000.0}, {-2.0, 2.0});
  const Interval within = {-1200.0, 1200.0};
  const std::vector<double> positions = balances(ramp, kHanging, within);
  EXPECT_EQ(positions.size(), count_sign_changes(ramp, kHanging, within, 0.001));
  for (const double s : positions) EXPECT_NEAR(0.002 * s, std::sin(s), 1e-12);
}

TEST(Balance, IsFoundOnRampsOfEverySlope) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const PiecewiseLinear torque({-30.0, draw(-29.0, 0.0), draw(0.1, 29.0), 30.0},
                                 {draw(-2.0, 2.0), draw(-2.0, 2.0), draw(-2.0, 2.0), draw(-2.0, 2.0)});
    const GravityTorque gravity = {draw(-1.5, 1.5), draw(-4.0, 4.0)};
    const Interval within = {draw(-50.0, -20.0), draw(20.0, 50.0)};
    EXPECT_EQ(balances(torque, gravity, within).size(), count_sign_changes(torque, gravity, within, 2e-4));
  }
}

TEST(Balance, OnABendIsThatBend) {
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const double bend = draw(-1.0, 1.0);
    const PiecewiseLinear torque({draw(-3.0, -1.1), bend, draw(1.1, 3.0)}, {draw(0.1, 2.0), 0.0, draw(-2.0, -0.1)});
    EXPECT_EQ(balances(torque, kWeightless, {-5.0, 5.0}), std::vector{bend});
    // Gravity's zero on the same bend, falling with the torque.
    EXPECT_EQ(balances(torque, {0.05, bend}, {-1.0, 1.0}), std::vector{bend});
  }
}

TEST(Balance, NextToABendIsFoundWhateverTheLinesRoundingThere) {
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const double bend = draw(-1.0, 1.0);
    // The first line ends above zero by less than its own rounding.
    const PiecewiseLinear torque({draw(-3.0, -1.1), bend, 2.0}, {draw(-2.0, -0.1), 1e-18, 1.0});
    const std::vector<double> positions = balances(torque, kWeightless, {-5.0, 5.0});
    ASSERT_EQ(positions.size(), 1U);
    EXPECT_NEAR(positions[0], bend, 1e-14);
  }
}

TEST(Balance, OverAStretchIsItsFirstPosition) {
  const PiecewiseLinear torque({0.0, 1.0, 2.0, 3.0}, {1.0, 0.0, 0.0, -2.0});
  EXPECT_EQ(balances(torque, kWeightless, {-1.0, 4.0}), std::vector{1.0});
  EXPECT_EQ(balances(torque, kWeightless, {1.5, 4.0}), std::vector{1.5});
  EXPECT_EQ(balances(torque, kWeightless, {-1.0, 1.5}), std::vector{1.0});
  EXPECT_TRUE(balances(torque, kWeightless, {1.2, 1.8}).empty());
}

TEST(Balance, IsNotListedWhereTheSurplusOnlyTouchesZero) {
  const PiecewiseLinear torque({0.0, 1.0, 2.0}, {1.0, 0.0, 2.0});
  EXPECT_TRUE(balances(torque, kWeightless, {-1.0, 4.0}).empty());
}

TEST(Balance, AtAnEndOfTheStretchIsListed) {
  const PiecewiseLinear torque({0.0, 1.0, 2.0}, {1.0, 0.0, -2.0});
  EXPECT_EQ(balances(torque, kWeightless, {1.0, 4.0}), std::vector{1.0});
  EXPECT_EQ(balances(torque, kWeightless, {0.5, 1.0}), std::vector{1.0});
}

TEST(Balance, IsSingleWhereTheRampTouchesGravitysSlope) {
  const std::vector<double> positions = balances(PiecewiseLinear({-1.0, 1.0}, {-1.0, 1.0}), kHanging, {-1.0, 1.0});
  ASSERT_EQ(positions.size(), 1U);
  EXPECT_NEAR(positions[0], 0.0, 1e-5);  // s - sin(s) is s^3 / 6: the sixth root of a rounding
}

TEST(Surplus, IsExtremeWhereSamplesSayOnSteepAndLongPieces) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const PiecewiseLinear torque({-40.0, draw(-1.0, 0.0), draw(0.1, 1.0), 40.0},
                                 {draw(-2.0, 2.0), draw(-2.0, 2.0), draw(-2.0, 2.0), draw(-2.0, 2.0)});
    const GravityTorque gravity = {draw(-1.5, 1.5), draw(-4.0, 4.0)};
    const Interval within = {draw(-50.0, 0.0), draw(0.1, 50.0)};
    Interval seen = {10.0, -10.0};
    auto piece = torque.pieces().begin();
    constexpr int kSamples = 40000;
    for (int i = 0; i <= kSamples; ++i) {
      const double s = within.lower + within.length() * i / kSamples;
      while (s > piece->to) ++piece;
      const double here = piece->at(s) - gravity.amplitude * std::sin(s - gravity.phase);
      seen = {std::min(seen.lower, here), std::max(seen.upper, here)};
    }
    // Samples are at most 1.25e-3 rad from the extreme: flat ones are missed by less than 1e-6, sharp ones by the
    // slope.
    EXPECT_NEAR(extreme_surplus(Extreme::kLowest, torque, gravity, within), seen.lower, 1e-2);
    EXPECT_NEAR(extreme_surplus(Extreme::kHighest, torque, gravity, within), seen.upper, 1e-2);
    EXPECT_LE(extreme_surplus(Extreme::kLowest, torque, gravity, within), seen.lower + 1e-12);
    EXPECT_GE(extreme_surplus(Extreme::kHighest, torque, gravity, within), seen.upper - 1e-12);
  }
}

}  // namespace
}  // namespace dualarm
