#include "core/systems/torque_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace dualarm {
namespace {

const TorqueTable kTable = {{-3.0, -1.0, 0.5, 2.0},
                            {-1.0, 0.5, 2.0},
                            {{-4.0, 2.0},
                             {-3.0, 2.0},
                             {-1.0, 2.0},
                             {-2.0, 5.0},
                             {-2.0, 4.0},
                             {-2.0, 1.0},
                             {-6.0, 1.0},
                             {-5.0, 2.0},
                             {-6.0, 1.0},
                             {-1.0, 0.5},
                             {-1.0, 0.5},
                             {-1.0, 0.5}}};

TEST(TorqueAtVelocity, IsTheLimitThereForEveryPartOfThePositions) {
  for (unsigned seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const double velocity = draw(-3.0, 3.0);
    const double low = draw(-5.0, 3.0);
    const Interval within = {low, low + draw(0.0, 4.0)};
    for (const Extreme extreme : {Extreme::kLowest, Extreme::kHighest}) {
      const PiecewiseLinear torque = torque_at_velocity(kTable, extreme, velocity, within);
      for (const LinearPiece& piece : torque.pieces()) {
        for (const double share : {0.0, 0.3, 1.0}) {
          const double s = std::lerp(within.lower, within.upper, share);
          if (s < piece.from || s > piece.to) continue;
          EXPECT_NEAR(piece.at(s), torque_end(extreme, torque_limits(kTable, s, velocity)), 1e-14) << s;
        }
      }
    }
  }
}

TEST(TorqueAtVelocity, IsTheNearestColumnAtInfiniteVelocity) {
  const PiecewiseLinear torque =
      torque_at_velocity(kTable, Extreme::kLowest, std::numeric_limits<double>::infinity(), {-1.0, 0.5});
  EXPECT_EQ(torque.bends({-9.0, 9.0}), (std::vector{-1.0, 0.5}));
  EXPECT_EQ(torque.pieces()[1].at(-1.0), -2.0);
}

TEST(TorqueDependence, OfALineIsInTheDrivingQuadrant) {
  const TorqueSpeedLine line = {3.0, 5.0};
  EXPECT_TRUE(torque_depends_on_velocity(line, Extreme::kHighest, 1.0));
  EXPECT_FALSE(torque_depends_on_velocity(line, Extreme::kHighest, -1.0));
  EXPECT_TRUE(torque_depends_on_velocity(line, Extreme::kLowest, -1.0));
  EXPECT_FALSE(torque_depends_on_velocity(line, Extreme::kLowest, 1.0));
}

TEST(TorqueDependence, IsOfTheDirectionInWhichColumnsDiffer) {
  const TorqueTable table = {{0.0}, {-2.0, 0.0, 1.0}, {{-3.0, 2.0}, {-3.0, 2.0}, {-3.0, 2.5}}};
  EXPECT_FALSE(torque_depends_on_velocity(table, Extreme::kHighest, -1.0));
  EXPECT_TRUE(torque_depends_on_velocity(table, Extreme::kHighest, 1.0));
  EXPECT_FALSE(torque_depends_on_velocity(table, Extreme::kLowest, 1.0));
  EXPECT_FALSE(torque_drives_best_at_rest(table, 0.0, 1.0));
  EXPECT_TRUE(torque_drives_best_at_rest(table, 0.5, 1.0));
  EXPECT_TRUE(torque_drives_best_at_rest(table, 0.0, -1.0));
}

TEST(TorqueDependence, ReachesAcrossStandstillToTheNearestColumn) {
  const TorqueTable table = {{0.0}, {-1.0, 1.0}, {{-3.0, 2.0}, {-3.0, 2.5}}};
  EXPECT_TRUE(torque_depends_on_velocity(table, Extreme::kHighest, -1.0));
  EXPECT_TRUE(torque_depends_on_velocity(table, Extreme::kHighest, 1.0));
}

}  // namespace
}  // namespace dualarm
