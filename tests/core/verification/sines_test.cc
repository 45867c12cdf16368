#include "core/verification/sines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/dice.h"

namespace dualarm {
namespace {

constexpr double kPromised = 1e-15;

void expect_right(const std::vector<double>& angles) {
  const Eigen::ArrayX2d found = sines_and_cosines(angles);
  ASSERT_EQ(found.rows(), static_cast<Eigen::Index>(angles.size()));
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const auto angle = static_cast<long double>(angles[i]);
    ASSERT_LE(std::abs(static_cast<long double>(found(row, 0)) - std::sin(angle)), kPromised) << i << ": " << angle;
    ASSERT_LE(std::abs(static_cast<long double>(found(row, 1)) - std::cos(angle)), kPromised) << i << ": " << angle;
  }
}

/// Steps from far too small to far too large to share a call, to and fro, and all counts.
TEST(Sines, HoldToTheirPromiseAlongEveryMotion) {
  Dice dice(11);
  for (int trial = 0; trial < 3000; ++trial) {
    SCOPED_TRACE(trial);
    const double step = std::pow(10.0, dice.between(-9.0, 0.5));
    const double drift = dice.between(-1.0, 1.0);
    std::vector<double> angles = {dice.between(-10.0, 10.0)};
    const auto count = static_cast<std::size_t>(dice.between(1.0, 60.0));
    while (angles.size() < count) angles.push_back(angles.back() + step * (drift + dice.between(-1.0, 1.0)));
    expect_right(angles);
  }
}

TEST(Sines, HoldToTheirPromiseAtTheLargestDifference) {
  for (const double middle : {0.0, 0.7, 1.5707963267948966, 3.0, -2.0}) {
    std::vector<double> angles(16, middle);
    angles.front() = middle - 0.25;
    angles.back() = middle + 0.25;
    expect_right(angles);
    angles.back() = middle + 0.2500001;
    expect_right(angles);
  }
}

TEST(Sines, OfAnArmThatStandsStillAreTheLibrarys) {
  const std::vector<double> angles(37, 1.234);
  const Eigen::ArrayX2d found = sines_and_cosines(angles);
  EXPECT_TRUE((found.col(0) == std::sin(1.234)).all());
  EXPECT_TRUE((found.col(1) == std::cos(1.234)).all());
}

TEST(Sines, OfNothingAreNone) { EXPECT_EQ(sines_and_cosines({}).rows(), 0); }

}  // namespace
}  // namespace dualarm
