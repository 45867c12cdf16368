#include "geometry/support.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/geometry/random_shapes.h"
#include "tests/support/exact_distance.h"

namespace dualarm {
namespace {

constexpr std::uint64_t kSeed = 43;
constexpr std::array kKinds = {Kind::kCapsule, Kind::kBox, Kind::kCylinder};

long double distance_of_point(const Eigen::Vector3d& point, const Shape& shape) {
  return exact_distance(Capsule{point, point, 0.0}, shape);
}

TEST(FarthestPoint, OfEachShapeByHand) {
  const Eigen::Vector3d up(0.0, 0.0, 2.0);
  const Shape capsule = Capsule{{1.0, 0.0, 0.0}, {1.0, 0.0, 3.0}, 0.5};
  EXPECT_TRUE(farthest_point(capsule, up).isApprox(Eigen::Vector3d(1.0, 0.0, 3.5)));
  Box box;
  box.half_extents = {1.0, 2.0, 3.0};
  EXPECT_TRUE(farthest_point(box, {1.0, -1.0, 1.0}).isApprox(Eigen::Vector3d(1.0, -2.0, 3.0)));
  const Shape cylinder = Cylinder{{0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}, 2.0};
  EXPECT_TRUE(farthest_point(cylinder, {3.0, 4.0, -0.1}).isApprox(Eigen::Vector3d(1.2, 1.6, -1.0)));
}

TEST(FarthestPoint, OfAFlatPartIsACornerOrARimPoint) {
  Box box;
  box.half_extents = {1.0, 2.0, 3.0};
  EXPECT_DOUBLE_EQ(farthest_point(box, Eigen::Vector3d::UnitX()).norm(), box.half_extents.norm());
  const Shape cylinder = Cylinder{{0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}, 2.0};
  EXPECT_DOUBLE_EQ(farthest_point(cylinder, Eigen::Vector3d::UnitZ()).head<2>().norm(), 2.0);
}

TEST(FarthestPoint, BelongsToTheShapeAndNoPointLiesFarther) {
  RandomShapes shapes(kSeed);
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", shape " << i);
    const Shape shape = shapes.shape(kKinds[i % 3], 2.0);
    const Eigen::Vector3d direction = shapes.direction();
    const Eigen::Vector3d found = farthest_point(shape, 1e-3 * direction);
    ASSERT_LE(distance_of_point(found, shape), 1e-13L);
    // The long double's own figure for how far a shape reaches.
    const Capsule origin;
    ASSERT_NEAR(static_cast<double>(-proven_distance(shape, origin, -direction)), direction.dot(found), 1e-13);
  }
}

TEST(BoundingBall, ContainsTheShapeAndTouchesIt) {
  RandomShapes shapes(kSeed);
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", shape " << i);
    const Shape shape = shapes.shape(kKinds[i % 3], 2.0);
    double farthest = 0.0;
    for (int j = 0; j < 50; ++j) {
      const double distance = (farthest_point(shape, shapes.direction()) - centre(shape)).norm();
      ASSERT_LE(distance, bounding_radius(shape) + 1e-14);
      farthest = std::max(farthest, distance);
    }
    ASSERT_GE(farthest, 0.7 * bounding_radius(shape)) << "the ball is much too large";
  }
}

TEST(BoundingBall, IsTheSmallest) {
  Box box;
  box.half_extents = {2.0, 3.0, 6.0};
  EXPECT_DOUBLE_EQ(bounding_radius(box), 7.0);
  EXPECT_DOUBLE_EQ(bounding_radius(Capsule{{1.0, 0.0, 0.0}, {4.0, 4.0, 0.0}, 0.5}), 3.0);
  EXPECT_DOUBLE_EQ(bounding_radius(Cylinder{{0.0, 0.0, 0.0}, {8.0, 0.0, 0.0}, 3.0}), 5.0);
  EXPECT_TRUE(centre(Cylinder{{0.0, 0.0, 0.0}, {8.0, 0.0, 0.0}, 3.0}).isApprox(Eigen::Vector3d(4.0, 0.0, 0.0)));
}

TEST(DistanceToBall, IsNeverMoreThanTheDistanceAndExactForCapsules) {
  RandomShapes shapes(kSeed);
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", shape " << i);
    const Shape shape = shapes.shape(kKinds[i % 3], 2.0);
    const Eigen::Vector3d middle = shapes.pose(2.0).translation();
    const double radius = shapes.dice().between(0.0, 1.0);
    const double found = distance_to_ball(shape, middle, radius);
    const auto exact = static_cast<double>(exact_distance(shape, Capsule{middle, middle, radius}));
    ASSERT_LE(found, exact + 1e-13);
    if (i % 3 == 0) {
      ASSERT_NEAR(found, exact, 1e-13);
    }
    ASSERT_GE(found, exact - 2.0 * bounding_radius(shape) - 1e-13);
  }
}

}  // namespace
}  // namespace dualarm
