#include "clients/cpp/motion_curve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dualarm {
namespace {

using planning::v1::Knots;

void add_knot(Knots& knots, double time, double position, double velocity, double acceleration) {
  knots.add_time_s(time);
  knots.add_position_rad(position);
  knots.add_velocity_rad_per_s(velocity);
  knots.add_acceleration_rad_per_s2(acceleration);
}

// Every quintic is its own Hermite interpolant.
double some_quintic(double t) { return 1.0 + t * (-2.0 + t * (0.5 + t * (3.0 + t * (-1.0 + 0.25 * t)))); }
double its_velocity(double t) { return -2.0 + t * (1.0 + t * (9.0 + t * (-4.0 + 1.25 * t))); }
double its_acceleration(double t) { return 1.0 + t * (18.0 + t * (-12.0 + 5.0 * t)); }

TEST(PositionAt, ReproducesAQuinticBetweenUnevenKnots) {
  Knots knots;
  for (const double t : {0.0, 0.3, 1.0, 2.5}) add_knot(knots, t, some_quintic(t), its_velocity(t), its_acceleration(t));
  for (int k = 0; k <= 100; ++k) {
    const double t = 0.025 * k;
    EXPECT_NEAR(position_at(knots, t), some_quintic(t), 1e-12) << "at " << t;
  }
}

TEST(PositionAt, HoldsBeforeTheFirstKnotAndAfterTheLast) {
  Knots knots;
  add_knot(knots, 1.0, 0.2, 0.0, 0.0);
  add_knot(knots, 2.0, 0.7, 0.0, 0.0);
  EXPECT_DOUBLE_EQ(position_at(knots, -5.0), 0.2);
  EXPECT_DOUBLE_EQ(position_at(knots, 2.0), 0.7);
  EXPECT_DOUBLE_EQ(position_at(knots, 9.0), 0.7);
}

TEST(PositionAt, PassesKnotsOfEqualTimeWithTheLaterOnesAcceleration) {
  Knots knots;  // bang-bang: +2 for a second, then -2 for a second
  add_knot(knots, 0.0, 0.0, 0.0, 2.0);
  add_knot(knots, 1.0, 1.0, 2.0, 2.0);
  add_knot(knots, 1.0, 1.0, 2.0, -2.0);
  add_knot(knots, 2.0, 2.0, 0.0, -2.0);
  EXPECT_NEAR(position_at(knots, 0.5), 0.25, 1e-15);
  EXPECT_NEAR(position_at(knots, 1.0), 1.0, 1e-15);
  EXPECT_NEAR(position_at(knots, 1.5), 1.75, 1e-15);
}

TEST(PositionAt, IsNotANumberForColumnsThatDoNotBelongTogether) {
  Knots knots;
  EXPECT_TRUE(std::isnan(position_at(knots, 0.0)));
  add_knot(knots, 0.0, 1.0, 0.0, 0.0);
  knots.add_time_s(1.0);
  EXPECT_TRUE(std::isnan(position_at(knots, 0.5)));
}

TEST(PathOf, SamplesBothArmsAtTheSameInstants) {
  Knots moving;
  Knots waiting;
  add_knot(moving, 0.0, 0.0, 1.0, 0.0);
  add_knot(moving, 2.0, 2.0, 1.0, 0.0);
  add_knot(waiting, 0.0, 3.0, 0.0, 0.0);
  add_knot(waiting, 2.0, 3.0, 0.0, 0.0);
  const auto path = path_of(moving, waiting, 2.0, 5);
  ASSERT_EQ(path.size(), 5U);
  EXPECT_DOUBLE_EQ(path[1].time, 0.5);
  EXPECT_NEAR(path[1].theta1, 0.5, 1e-15);
  EXPECT_DOUBLE_EQ(path[1].theta2, 3.0);
  EXPECT_DOUBLE_EQ(path[4].theta1, 2.0);
}

}  // namespace
}  // namespace dualarm
