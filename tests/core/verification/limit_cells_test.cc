#include "core/verification/limit_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace dualarm {
namespace {

const TorqueTable kTable = {{0.0, 1.0, 3.0},
                            {-1.0, 1.0},
                            {{-10.0, 10.0}, {-20.0, 30.0}, {-12.0, 18.0}, {-40.0, 22.0}, {-8.0, 50.0}, {-30.0, 5.0}}};

TEST(LimitCells, InsideOneCellTheLimitsAreTheBilinearFunctionsThemselves) {
  const LimitCells cells(kTable);
  const auto over = cells.over({0.2, 0.7}, {-0.9, 0.5}, {0.4, 0.1});
  ASSERT_TRUE(over);
  EXPECT_LT(over->lower_error, 1e-13);
  EXPECT_LT(over->upper_error, 1e-13);
  for (const JointState state : {JointState{0.2, -0.9}, {0.7, 0.5}, {0.33, -0.12}}) {
    const Interval limits = torque_limits(kTable, state.position, state.velocity);
    EXPECT_NEAR(over->lower.at(state), limits.lower, 1e-13);
    EXPECT_NEAR(over->upper.at(state), limits.upper, 1e-13);
  }
  // upper = 10 + 8 p + 20 s - 16 p s with s = (v + 1) / 2
  EXPECT_NEAR(over->upper.per_position, 8.0 - 16.0 * 0.55, 1e-13);
  EXPECT_NEAR(over->upper.per_velocity, 10.0 - 8.0 * 0.4, 1e-13);
  EXPECT_NEAR(over->upper.mixed, -8.0, 1e-13);
}

TEST(LimitCells, ErrorsAndExtremesHoldAcrossBendsAndAreAttained) {
  const LimitCells cells(kTable);
  const Interval positions = {0.5, 3.6};
  const Interval velocities = {-1.4, 0.4};
  const auto over = cells.over(positions, velocities, {0.6, 0.0});
  ASSERT_TRUE(over);
  double lower_error = 0.0;
  double upper_error = 0.0;
  Interval upper = {1e9, -1e9};
  Interval half_width = {1e9, -1e9};
  for (int i = 0; i <= 310; ++i) {
    for (int j = 0; j <= 180; ++j) {
      const JointState state = {positions.lower + 0.01 * i, velocities.lower + 0.01 * j};
      const Interval limits = cells.at(state);
      lower_error = std::max(lower_error, std::abs(limits.lower - over->lower.at(state)));
      upper_error = std::max(upper_error, std::abs(limits.upper - over->upper.at(state)));
      upper = {std::min(upper.lower, limits.upper), std::max(upper.upper, limits.upper)};
      const double half = 0.5 * limits.length();
      half_width = {std::min(half_width.lower, half), std::max(half_width.upper, half)};
    }
  }
  EXPECT_NEAR(over->lower_error, lower_error, 1e-9);
  EXPECT_NEAR(over->upper_error, upper_error, 1e-9);
  EXPECT_NEAR(over->upper_extremes.lower, upper.lower, 1e-9);
  EXPECT_NEAR(over->upper_extremes.upper, upper.upper, 1e-9);
  EXPECT_NEAR(over->half_width_extremes.lower, half_width.lower, 1e-9);
  EXPECT_NEAR(over->half_width_extremes.upper, half_width.upper, 1e-9);
}

TEST(LimitCells, BeyondTheOutermostBendsNothingChanges) {
  const auto over = LimitCells(kTable).over({4.0, 5.0}, {2.0, 3.0}, {4.5, 2.5});
  ASSERT_TRUE(over);
  EXPECT_EQ(over->upper.value, 5.0);
  EXPECT_EQ(over->lower.value, -30.0);
  EXPECT_EQ(over->upper.per_position, 0.0);
  EXPECT_EQ(over->upper.per_velocity, 0.0);
  EXPECT_EQ(over->upper_error, 0.0);
}

TEST(LimitCells, AStateOnABendIsServedFromEitherSideWithoutError) {
  const LimitCells cells(TorqueSpeedLine{60.0, 3.0});
  for (const double velocity : {-3.0, 0.0, 3.0}) {
    const auto over = cells.over({0.2, 0.3}, {velocity, velocity}, {0.25, velocity});
    ASSERT_TRUE(over);
    EXPECT_EQ(over->upper_error, 0.0);
    EXPECT_EQ(over->lower_error, 0.0);
  }
}

TEST(LimitCells, TheErrorAcrossABendFallsWithTheWayBeyondIt) {
  const LimitCells cells(TorqueSpeedLine{60.0, 3.0});
  for (const double beyond : {1e-3, 1e-9, 1e-15}) {
    const auto over = cells.over({0.0, 0.0}, {-beyond, 0.5}, {0.0, 0.25});
    ASSERT_TRUE(over);
    EXPECT_NEAR(over->upper_error, 20.0 * beyond, 1e-13);
    EXPECT_NEAR(over->lower_error, 20.0 * beyond, 1e-13);
  }
}

TEST(LimitCells, ABoxOverManyBendsHasToBeCut) {
  TorqueTable fine = {{}, {0.0}, {}};
  fine.positions.resize(1000);
  std::iota(fine.positions.begin(), fine.positions.end(), 0.0);
  fine.limits.assign(1000, {-1.0, 1.0});
  const LimitCells cells(fine);
  EXPECT_FALSE(cells.over({0.5, 900.5}, {0.0, 0.0}, {400.0, 0.0}));
  EXPECT_TRUE(cells.over({400.5, 402.5}, {0.0, 0.0}, {401.0, 0.0}));
}

}  // namespace
}  // namespace dualarm
