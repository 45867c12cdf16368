#include "geometry/motion_bound.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/chain.h"
#include "geometry/support.h"
#include "tests/geometry/random_shapes.h"
#include "tests/support/exact_distance.h"

namespace dualarm {
namespace {

TEST(MotionBound, ALinkReachesItsLengthAndRadius) {
  EXPECT_DOUBLE_EQ(reach(Capsule{{0.0, 0.0, 0.0}, {6.0, 0.0, 0.0}, 0.25}), 6.25);
}

TEST(MotionBound, TheNearEndMayBeTheFarOne) {
  EXPECT_DOUBLE_EQ(reach(Capsule{{3.0, 4.0, 0.0}, {1.0, 0.0, 0.0}, 0.5}), 5.5);
}

TEST(MotionBound, HeightAboveThePlaneAddsNothing) {
  EXPECT_DOUBLE_EQ(reach(Capsule{{3.0, 4.0, 7.0}, {0.0, 0.0, -9.0}, 0.0}), 5.0);
}

TEST(MotionBound, DistanceToAnythingFixedChangesByNoMoreThanReachTimesAngle) {
  std::mt19937_64 generator(20);
  std::uniform_real_distribution<double> number(-3.0, 3.0);
  const auto point = [&] { return Eigen::Vector3d(number(generator), number(generator), number(generator)); };
  double largest_use = 0.0;
  for (int i = 0; i < 20000; ++i) {
    SCOPED_TRACE(i);
    const Capsule body = {point(), point(), 0.1};
    const Capsule fixed = {point(), point(), 0.2};
    const double from = number(generator);
    const double to = from + 0.1 * number(generator);
    const auto distance = [&](double position) {
      return static_cast<double>(exact_distance(placed(body, link_pose(Base{}, position)), fixed));
    };
    const double change = std::abs(distance(to) - distance(from));
    ASSERT_LE(change, reach(body) * std::abs(to - from) + 1e-12);
    largest_use = std::max(largest_use, change / (reach(body) * std::abs(to - from)));
  }
  EXPECT_GT(largest_use, 0.9) << "the bound is not far from what happens";
}

TEST(MotionBound, OfABoxIsThatOfItsFarthestCorner) {
  Box box;
  box.pose.translation() = Eigen::Vector3d(2.0, 3.0, 9.0);
  box.half_extents = {1.0, 1.0, 3.0};
  EXPECT_DOUBLE_EQ(reach(box), 5.0);
  EXPECT_DOUBLE_EQ(extent(box), 13.0);
}

TEST(MotionBound, OfACylinderUprightOrLyingIsExact) {
  EXPECT_DOUBLE_EQ(reach(Cylinder{{3.0, 4.0, 0.0}, {3.0, 4.0, 7.0}, 1.0}), 6.0);
  EXPECT_DOUBLE_EQ(reach(Cylinder{{0.0, 0.0, 2.0}, {4.0, 0.0, 2.0}, 3.0}), 5.0);
  EXPECT_DOUBLE_EQ(extent(Cylinder{{0.0, 0.0, 2.0}, {4.0, 0.0, 2.0}, 1.0}), 5.0);
  EXPECT_DOUBLE_EQ(extent(Cylinder{{1.0, 0.0, 0.0}, {1.0, 0.0, 4.0}, 2.0}), 5.0);
}

TEST(MotionBound, OfAWaferIsThatOfTheBallAroundIt) {
  EXPECT_DOUBLE_EQ(reach(Cylinder{{3.0, 4.0, 1.0}, {3.0, 4.0, 1.0}, 1.0}), 6.0);
  EXPECT_DOUBLE_EQ(extent(Cylinder{{2.0, 3.0, 6.0}, {2.0, 3.0, 6.0}, 1.0}), 8.0);
}

TEST(MotionBound, NoPointOfAnyShapeLiesFartherAndOneAlmostThere) {
  constexpr std::uint64_t kSeed = 53;
  constexpr std::array kKinds = {Kind::kCapsule, Kind::kBox, Kind::kCylinder};
  RandomShapes shapes(kSeed);
  for (int i = 0; i < 1500; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", shape " << i);
    const Shape shape = shapes.shape(kKinds[i % 3], 2.0);
    double farthest_from_axis = 0.0;
    double farthest_from_origin = 0.0;
    constexpr int kDirections = 60;
    for (int j = 0; j < kDirections; ++j) {
      const double angle = 2.0 * std::numbers::pi * j / kDirections;
      const Eigen::Vector3d flat(std::cos(angle), std::sin(angle), 0.0);
      farthest_from_axis = std::max(farthest_from_axis, farthest_point(shape, flat).head<2>().norm());
      for (const double height : {-1.5, -0.5, 0.0, 0.5, 1.5}) {
        const Eigen::Vector3d point = farthest_point(shape, flat + height * Eigen::Vector3d::UnitZ());
        farthest_from_origin = std::max(farthest_from_origin, point.norm());
      }
    }
    ASSERT_LE(farthest_from_axis, reach(shape) + 1e-13);
    ASSERT_LE(farthest_from_origin, extent(shape) + 1e-13);
    ASSERT_GE(farthest_from_axis, 0.8 * reach(shape)) << "a leaning cylinder's bound is no more than that too large";
    ASSERT_GE(farthest_from_origin, 0.9 * extent(shape));
  }
}

TEST(SweptGap, IsTheDistanceOfABallFromTheDiscThatALinkSweeps) {
  const Base base = {{1.0, 2.0, 3.0}, 0.4, Rotation::kClockwise};
  const Capsule link = {{0.0, 0.0, 0.0}, {5.5, 0.0, 0.0}, 0.5};
  const auto ball = [](const Eigen::Vector3d& at) { return Capsule{at, at, 0.25}; };
  EXPECT_DOUBLE_EQ(swept_gap(base, link, ball({11.0, 2.0, 3.0})), 4.0 - 0.25);
  EXPECT_DOUBLE_EQ(swept_gap(base, link, ball({1.0, 2.0, 7.0})), 3.5 - 0.25);
  EXPECT_DOUBLE_EQ(swept_gap(base, link, ball({1.0, 11.0, -4.5})), std::hypot(3.0, 7.0) - 0.25);
  EXPECT_LT(swept_gap(base, link, ball({4.0, 2.0, 3.2})), 0.0);
}

TEST(SweptGap, IsNeverMoreThanTheDistanceAtAnyPosition) {
  constexpr std::uint64_t kSeed = 73;
  RandomShapes shapes(kSeed);
  int far = 0;
  for (int i = 0; i < 1500; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", pair " << i);
    const Shape moving = shapes.shape(static_cast<Kind>(i % 3), 2.0);
    const Shape standing = shapes.shape(static_cast<Kind>(i / 3 % 3), 2.0);
    const Base base = {3.0 * shapes.direction(), shapes.dice().between(-3.0, 3.0), Rotation::kClockwise};
    const double found = swept_gap(base, moving, standing);
    far += found > 0.0 ? 1 : 0;
    for (int j = 0; j < 30; ++j) {
      const Shape there = placed(moving, link_pose(base, shapes.dice().between(-3.0, 3.0)));
      ASSERT_GE((shapes.point_of(there) - shapes.point_of(standing)).norm(), found - 1e-12);
    }
  }
  EXPECT_GT(far, 100);
}

}  // namespace
}  // namespace dualarm
