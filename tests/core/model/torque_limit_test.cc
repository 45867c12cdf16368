#include "core/model/torque_limit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dualarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

const TorqueTable kTable = {{0.0, 1.0, 3.0},
                            {-1.0, 1.0},
                            {{-10.0, 10.0}, {-20.0, 30.0}, {-12.0, 18.0}, {-40.0, 22.0}, {-8.0, 50.0}, {-30.0, 5.0}}};

void expect_near(Interval limits, Interval wanted, double tolerance = 1e-13) {
  EXPECT_NEAR(limits.lower, wanted.lower, tolerance);
  EXPECT_NEAR(limits.upper, wanted.upper, tolerance);
}

TEST(TorqueLimit, ConstantLimitsAreTheSameEverywhere) {
  const TorqueLimit limit = Interval{-3.0, 7.0};
  EXPECT_EQ(torque_limits(limit, -1e9, 1e9), (Interval{-3.0, 7.0}));
  EXPECT_EQ(torque_bounds(limit), (Interval{-3.0, 7.0}));
  EXPECT_THAT(position_bends(limit), IsEmpty());
  EXPECT_THAT(velocity_bends(limit), IsEmpty());
}

TEST(TorqueLimit, ALineFallsInTheDrivingQuadrantAndIsFullInTheBrakingOne) {
  const TorqueLimit limit = TorqueSpeedLine{60.0, 3.0};
  expect_near(torque_limits(limit, 0.0, 0.0), {-60.0, 60.0});
  expect_near(torque_limits(limit, 0.0, 1.0), {-60.0, 40.0});
  expect_near(torque_limits(limit, 0.0, -1.0), {-40.0, 60.0});
  expect_near(torque_limits(limit, 0.0, 3.0), {-60.0, 0.0});
  expect_near(torque_limits(limit, 0.0, -3.0), {0.0, 60.0});
  expect_near(torque_limits(limit, 0.0, 1e300), {-60.0, 0.0});
  expect_near(torque_limits(limit, 0.0, -kInfinity), {0.0, 60.0});
}

TEST(TorqueLimit, ALineIsTheSameInBothSensesAndAtEveryPosition) {
  const TorqueLimit limit = TorqueSpeedLine{17.0, 0.7};
  for (double velocity = -1.0; velocity <= 1.0; velocity += 0.01) {
    const Interval here = torque_limits(limit, 0.3, velocity);
    const Interval mirrored = torque_limits(limit, -2.0, -velocity);
    EXPECT_EQ(here.lower, -mirrored.upper);
    EXPECT_EQ(here.upper, -mirrored.lower);
    EXPECT_LT(here.lower, here.upper);
  }
}

TEST(TorqueLimit, ALineBendsAtStandstillAndAtBothNoLoadSpeeds) {
  const TorqueLimit limit = TorqueSpeedLine{60.0, 3.0};
  EXPECT_THAT(position_bends(limit), IsEmpty());
  EXPECT_THAT(velocity_bends(limit), ElementsAre(-3.0, 0.0, 3.0));
  EXPECT_EQ(torque_bounds(limit), (Interval{-60.0, 60.0}));
}

TEST(TorqueLimit, ATableHoldsItsEntriesAtItsCornersExactly) {
  for (std::size_t row = 0; row < kTable.positions.size(); ++row) {
    for (std::size_t column = 0; column < kTable.velocities.size(); ++column) {
      EXPECT_EQ(torque_limits(kTable, kTable.positions[row], kTable.velocities[column]),
                kTable.limits[row * kTable.velocities.size() + column]);
    }
  }
}

TEST(TorqueLimit, ATableIsBilinearBetweenItsCorners) {
  expect_near(torque_limits(kTable, 0.5, -1.0), {-11.0, 14.0});
  expect_near(torque_limits(kTable, 0.0, 0.0), {-15.0, 20.0});
  expect_near(torque_limits(kTable, 0.5, 0.0), {-20.5, 20.0});
  expect_near(torque_limits(kTable, 2.5, 0.5),
              {-0.25 * (0.25 * 12.0 + 0.75 * 40.0) - 0.75 * (0.25 * 8.0 + 0.75 * 30.0),
               0.25 * (0.25 * 18.0 + 0.75 * 22.0) + 0.75 * (0.25 * 50.0 + 0.75 * 5.0)});
}

TEST(TorqueLimit, OutsideTheGridTheNearestEdgeHolds) {
  expect_near(torque_limits(kTable, -5.0, -7.0), {-10.0, 10.0});
  expect_near(torque_limits(kTable, 100.0, 1e300), {-30.0, 5.0});
  expect_near(torque_limits(kTable, 0.5, 2.0), torque_limits(kTable, 0.5, 1.0));
  expect_near(torque_limits(kTable, -kInfinity, 0.0), torque_limits(kTable, 0.0, 0.0));
}

TEST(TorqueLimit, ATableOfOneRowOrColumnOrEntryIsConstantAcross) {
  const TorqueLimit row = TorqueTable{{0.7}, {-1.0, 1.0}, {{-10.0, 10.0}, {-20.0, 40.0}}};
  for (const double position : {-9.0, 0.7, 9.0}) expect_near(torque_limits(row, position, 0.5), {-17.5, 32.5});
  const TorqueLimit column = TorqueTable{{-1.0, 1.0}, {0.7}, {{-10.0, 10.0}, {-20.0, 40.0}}};
  for (const double velocity : {-9.0, 0.7, 9.0}) expect_near(torque_limits(column, 0.5, velocity), {-17.5, 32.5});
  const TorqueLimit entry = TorqueTable{{0.0}, {0.0}, {{-1.0, 2.0}}};
  for (const double value : {-9.0, 0.0, 9.0}) EXPECT_EQ(torque_limits(entry, value, -value), (Interval{-1.0, 2.0}));
}

TEST(TorqueLimit, ATableBendsAtItsGridAndIsBoundedByItsEntries) {
  EXPECT_THAT(position_bends(kTable), ElementsAre(0.0, 1.0, 3.0));
  EXPECT_THAT(velocity_bends(kTable), ElementsAre(-1.0, 1.0));
  EXPECT_EQ(torque_bounds(kTable), (Interval{-40.0, 50.0}));
}

TEST(TorqueLimit, EveryLimitIsContinuousBoundedAndStraightBetweenBends) {
  constexpr double kSteepest = 61.0;  // N m per rad or rad/s; the steepest line has 60
  for (const TorqueLimit& limit : {TorqueLimit(Interval{-3.0, 7.0}), TorqueLimit(TorqueSpeedLine{60.0, 3.0}),
                                   TorqueLimit(TorqueSpeedLine{30.0, 0.5}), TorqueLimit(kTable)}) {
    SCOPED_TRACE(limit.index());
    const Interval bounds = torque_bounds(limit);
    const auto holds_a_bend = [](const std::vector<double>& bends, double from, double to) {
      return std::any_of(bends.begin(), bends.end(), [&](double bend) { return from <= bend && bend <= to; });
    };
    constexpr double kStep = 0.013;
    for (double position = -0.5; position < 3.5; position += kStep) {
      for (double velocity = -3.5; velocity < 3.5; velocity += kStep) {
        const Interval here = torque_limits(limit, position, velocity);
        const Interval ahead = torque_limits(limit, position + kStep, velocity);
        const Interval faster = torque_limits(limit, position, velocity + kStep);
        ASSERT_LE(bounds.lower, here.lower);
        ASSERT_GE(bounds.upper, here.upper);
        ASSERT_LT(here.lower, here.upper);
        ASSERT_NEAR(here.upper, ahead.upper, kSteepest * kStep);
        ASSERT_NEAR(here.lower, ahead.lower, kSteepest * kStep);
        ASSERT_NEAR(here.upper, faster.upper, kSteepest * kStep);
        ASSERT_NEAR(here.lower, faster.lower, kSteepest * kStep);
        if (!holds_a_bend(position_bends(limit), position, position + kStep)) {
          const Interval between = torque_limits(limit, position + 0.5 * kStep, velocity);
          ASSERT_NEAR(between.upper, 0.5 * (here.upper + ahead.upper), 1e-12);
        }
        if (!holds_a_bend(velocity_bends(limit), velocity, velocity + kStep)) {
          const Interval between = torque_limits(limit, position, velocity + 0.5 * kStep);
          ASSERT_NEAR(between.lower, 0.5 * (here.lower + faster.lower), 1e-12);
        }
      }
    }
  }
}

}  // namespace
}  // namespace dualarm
