#include "core/verification/separation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/verification/tolerances.h"
#include "geometry/chain.h"
#include "geometry/clearance.h"
#include "geometry/motion_bound.h"
#include "tests/support/dice.h"
#include "tests/support/exact_distance.h"

namespace dualarm {
namespace {

/// A body that turns with a constant angular acceleration about an axis through an origin with a constant velocity.
struct Turning {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  Shape shape;
  double angle = 0.0;
  double rate = 0.0;
  double rate_change = 0.0;

  Shape at(double t) const {
    const double turned = angle + t * rate + 0.5 * t * t * rate_change;
    return placed(shape, Eigen::Translation3d(origin + t * velocity) * Eigen::AngleAxisd(turned, axis));
  }
  TurningBody body(double half_interval) const {
    return {at(0.0),
            origin,
            velocity,
            axis,
            rate,
            std::abs(rate) + half_interval * std::abs(rate_change),
            std::abs(rate_change),
            half_interval * (std::abs(rate) + 0.5 * half_interval * std::abs(rate_change)),
            axis == Eigen::Vector3d::UnitZ() ? reach(shape) : extent(shape),
            extent(shape),
            0.0};
  }
};

enum class Kind { kCapsule, kBox, kCylinder };

struct RandomTurning {
  explicit RandomTurning(std::uint64_t seed) : dice(seed) {}

  Eigen::Vector3d within(double x, double y, double z) {
    return {dice.between(-x, x), dice.between(-y, y), dice.between(-z, z)};
  }
  Shape shape(Kind kind) {
    const Eigen::Vector3d from(dice.between(0.0, 1.0), dice.between(-1.0, 1.0), 0.0);
    const Eigen::Vector3d to(dice.between(1.0, 6.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
    const double radius = dice.between(0.01, 0.3);
    if (kind == Kind::kCapsule) return Capsule{from, to, radius};
    if (kind == Kind::kCylinder) return Cylinder{from, to, radius};
    const Eigen::AngleAxisd turned(dice.between(0.0, 3.0), within(1.0, 1.0, 1.0).normalized());
    const Eigen::Vector3d half(dice.between(0.0, 2.0), dice.between(0.0, 1.0), dice.between(0.0, 0.5));
    return Box{Eigen::Translation3d(from) * turned, half};
  }
  Turning on_joint(double x, Kind kind) {
    return {within(0.0, 1.0, 0.5) + Eigen::Vector3d(x, 0.0, 0.0),
            Eigen::Vector3d::Zero(),
            Eigen::Vector3d::UnitZ(),
            shape(kind),
            dice.between(-3.0, 3.0),
            dice.between(-2.0, 2.0),
            dice.between(-4.0, 4.0)};
  }
  Turning on_track(double x, Kind kind) {
    return {within(0.0, 3.0, 0.5) + Eigen::Vector3d(x, 0.0, 0.0),
            within(3.0, 3.0, 1.0),
            within(1.0, 1.0, 1.0).normalized(),
            shape(kind),
            dice.between(-3.0, 3.0),
            dice.between(-2.0, 2.0),
            0.0};
  }
  Turning any(double x, Kind kind) { return dice.happens(0.5) ? on_joint(x, kind) : on_track(x, kind); }
  Kind with_corners() { return dice.happens(0.5) ? Kind::kBox : Kind::kCapsule; }

  Dice dice;
};

double true_minimum(const Turning& first, const Turning& second, double half_interval, int steps = 100) {
  double least = 1e300;
  for (int k = -steps; k <= steps; ++k) {
    const double t = half_interval * k / steps;
    least = std::min(least, static_cast<double>(exact_distance(first.at(t), second.at(t))));
  }
  return least;
}

/// Over the whole interval.
double separation_bound(const TurningBody& first, const TurningBody& second, const Eigen::Vector3d& normal,
                        double half_interval) {
  const Separation found = separation(first, second, normal, half_interval);
  return std::min(found.least_before(), found.least_after());
}

/// From the nearest point of the second to that of the first, or any direction where they overlap.
Eigen::Vector3d normal_of(const Turning& first, const Turning& second) {
  const Clearance found = clearance(first.at(0.0), second.at(0.0));
  const Eigen::Vector3d across = found.point_on_first - found.point_on_second;
  return across.norm() > kShortestNormal ? across.normalized() : Eigen::Vector3d::UnitX();
}

/// An overlap counts as 0 there, whatever its depth.
void expect_no_more_than_the_truth(double bound, const Turning& first, const Turning& second, double half, int steps) {
  ASSERT_LE(bound, true_minimum(first, second, half, steps) + 1e-12);
}

TEST(Separation, NeverClaimsMoreThanTheSmallestDistance) {
  RandomTurning random(5);
  for (int i = 0; i < 1500; ++i) {
    SCOPED_TRACE(testing::Message() << "seed 5, pair " << i);
    const Turning first = random.any(0.0, random.with_corners());
    const Turning second = random.any(8.0, random.with_corners());
    const double half = std::pow(10.0, random.dice.between(-4.0, -0.3));
    const double bound = separation_bound(first.body(half), second.body(half), normal_of(first, second), half);
    expect_no_more_than_the_truth(bound, first, second, half, 20);
  }
}

TEST(Separation, NeverClaimsMoreThanTheSmallestDistanceOfCylinders) {
  RandomTurning random(15);
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(testing::Message() << "seed 15, pair " << i);
    const Turning first = random.any(0.0, Kind::kCylinder);
    const Turning second = random.any(8.0, i % 2 == 0 ? Kind::kCylinder : random.with_corners());
    const double half = std::pow(10.0, random.dice.between(-2.0, -0.3));
    const double bound = separation_bound(first.body(half), second.body(half), normal_of(first, second), half);
    expect_no_more_than_the_truth(bound, first, second, half, 4);
  }
}

TEST(Separation, HoldsForAnyNormal) {
  RandomTurning random(6);
  for (int i = 0; i < 1500; ++i) {
    SCOPED_TRACE(testing::Message() << "seed 6, pair " << i);
    const Turning first = random.any(0.0, random.with_corners());
    const Turning second = random.any(8.0, random.with_corners());
    const Eigen::Vector3d normal = random.within(1.0, 1.0, 1.0).normalized();
    const double half = 0.05;
    expect_no_more_than_the_truth(separation_bound(first.body(half), second.body(half), normal, half), first, second,
                                  half, 20);
  }
}

/// Each Fall alone, over any part of its half: what it keeps of a distance is true, and it keeps as much as it says.
TEST(Separation, KeepsADistanceForAsLongAsItSays) {
  RandomTurning random(7);
  int kept = 0;
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed 7, pair " << i);
    const Turning first = random.any(0.0, random.with_corners());
    const Turning second = random.any(8.0, random.with_corners());
    const double half = std::pow(10.0, random.dice.between(-3.0, -0.3));
    const Separation found = separation(first.body(half), second.body(half), normal_of(first, second), half);
    const double goal =
        static_cast<double>(exact_distance(first.at(0.0), second.at(0.0))) - random.dice.between(0.0, 0.5);
    const auto expect_kept = [&](const Fall& fall, double sign) {
      const double until = fall.keeps(goal, half);
      ASSERT_LE(until, half);
      if (!(until > 0.0)) return;
      ++kept;
      EXPECT_GE(fall.least_until(until), goal - 1e-12);
      if (until < half) {
        EXPECT_LT(fall.least_until(1.001 * until), goal);
      }
      for (int k = 0; k <= 20; ++k) {
        const double t = sign * until * k / 20;
        ASSERT_GE(static_cast<double>(exact_distance(first.at(t), second.at(t))), goal - 1e-12) << t;
      }
    };
    for (const Fall& fall : found.before) expect_kept(fall, -1.0);
    for (const Fall& fall : found.after) expect_kept(fall, 1.0);
  }
  EXPECT_GT(kept, 500);
}

TEST(Fall, ClaimsNothingOfWhatIsNotANumber) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Fall still = {{{{2.0, 0.0}, {2.0, -1.0}}}, 0.0};
  EXPECT_EQ(still.keeps(2.0, 5.0), 5.0);
  EXPECT_EQ(still.keeps(2.1, 5.0), 0.0);
  const Fall endless = {{{{2.0, -infinity}, {2.0, 0.0}}}, infinity};
  EXPECT_EQ(endless.least_until(1.0), -infinity);
  EXPECT_EQ(endless.keeps(1.0, 5.0), 0.0);
  const Fall nowhere = {{{{std::nan(""), 0.0}, {2.0, 0.0}}}, 1.0};
  EXPECT_EQ(nowhere.least_until(1.0), -infinity);
  EXPECT_EQ(nowhere.keeps(1.0, 5.0), 0.0);
}

TEST(Separation, LosesNothingWhereLinksAreNearestAtTheirJoints) {
  Turning left;
  left.shape = Capsule{Eigen::Vector3d::Zero(), {6.0, 0.0, 0.0}, 0.1};
  left.angle = 2.0;
  left.rate = 1.5;
  left.rate_change = -3.0;
  Turning right = left;
  right.origin = {8.0, 0.0, 0.0};
  right.angle = 0.9;
  EXPECT_NEAR(separation_bound(left.body(0.05), right.body(0.05), -Eigen::Vector3d::UnitX(), 0.05), 7.8,
              2.0 * kSeparationRounding);
}

TEST(Separation, IsTheDistanceForAnInstant) {
  RandomTurning random(8);
  for (int i = 0; i < 1500; ++i) {
    SCOPED_TRACE(testing::Message() << "seed 8, pair " << i);
    const Turning first = random.any(0.0, random.with_corners());
    const Turning second = random.any(8.0, random.with_corners());
    const auto distance = static_cast<double>(exact_distance(first.at(0.0), second.at(0.0)));
    if (distance < 1e-3) continue;
    ASSERT_NEAR(separation_bound(first.body(0.0), second.body(0.0), normal_of(first, second), 0.0), distance, 2e-7);
  }
}

/// What the bound loses over an interval of 2 h, relative to h squared, for h of 0.01 and 0.001 s.
void expect_loss_with_the_square(const Turning& first, const Turning& second, double most) {
  const Eigen::Vector3d normal = normal_of(first, second);
  for (const double half : {1e-2, 1e-3}) {
    const double bound = separation_bound(first.body(half), second.body(half), normal, half);
    EXPECT_LT(true_minimum(first, second, half) - bound, most * half * half + 2.0 * kSeparationRounding) << half;
  }
}

TEST(Separation, LosesWithTheSquareOfTheIntervalWhereATipSlidesAlongALink) {
  // The first link turns after the tip of the second, which slides along it: the distance keeps still to first order.
  Turning first;
  first.shape = Capsule{{0.0, 0.0, 0.0}, {6.0, 0.0, 0.0}, 0.1};
  first.angle = 0.5;
  first.rate = 1.0;
  const Eigen::Vector3d along(std::cos(0.5), std::sin(0.5), 0.0);
  const Eigen::Vector3d across(-std::sin(0.5), std::cos(0.5), 0.0);
  Turning second;
  second.origin = 4.0 * along + 0.3 * across + 5.0 * std::sqrt(0.5) * (along + across);
  second.shape = Capsule{{0.0, 0.0, 0.0}, {5.0, 0.0, 0.0}, 0.1};
  second.angle = 0.5 + 1.25 * std::numbers::pi;
  second.rate = -0.8 * std::sqrt(2.0);
  expect_loss_with_the_square(first, second, 20.0);
}

/// A box over which another one stands, its face parallel to that of the first.
struct Faces {
  Turning below;
  Turning above;

  Faces(const Eigen::Vector3d& half_above, double offset) {
    below.shape = Box{Eigen::Isometry3d::Identity(), {1.0, 0.5, 0.5}};
    below.rate = 0.7;
    above.origin = {offset, 0.7 + half_above.y(), 0.0};
    above.shape = Box{Eigen::Isometry3d::Identity(), half_above};
    above.velocity = {1.0, 0.0, 0.0};
    above.rate = -1.1;
  }
};

TEST(Separation, LosesWithTheSquareOfTheIntervalWhereAFaceTiltsOverAnother) {
  // Any tilt brings a corner of the upper box nearer: to first order, and the bound says so.
  Faces faces({0.3, 0.3, 0.2}, 0.2);
  expect_loss_with_the_square(faces.below, faces.above, 20.0);
  faces.above.axis = Eigen::Vector3d(1.0, 0.0, 1.0).normalized();
  expect_loss_with_the_square(faces.below, faces.above, 20.0);
}

TEST(Separation, LosesWithTheSquareOfTheIntervalWhereFacesRollOverEachOther) {
  // They overlap in part: a corner of the lower box is nearest before, one of the upper box after.
  const Faces faces({1.0, 0.5, 0.5}, 0.6);
  expect_loss_with_the_square(faces.below, faces.above, 20.0);
  expect_loss_with_the_square(faces.above, faces.below, 20.0);
}

TEST(Separation, LosesWithTheSquareOfTheIntervalWhereABallRunsPastACylinder) {
  Turning post;
  post.shape = Cylinder{{0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}, 0.3};
  Turning ball;
  ball.origin = {0.0, 0.6, 0.1};
  ball.velocity = {4.0, 0.0, 0.0};
  ball.shape = Capsule{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 0.1};
  const Eigen::Vector3d normal = normal_of(post, ball);
  for (const double half : {1e-2, 1e-3}) {
    const double bound = separation_bound(post.body(half), ball.body(half), normal, half);
    EXPECT_LT(0.2 - bound, 40.0 * half * half + 2.0 * kSeparationRounding) << half;
    EXPECT_LE(bound, 0.2);
  }
}

}  // namespace
}  // namespace dualarm
