#include "geometry/nearest_points.h"

#include <gtest/gtest.h>

#include <array>

#include "geometry/support.h"
#include "tests/geometry/random_shapes.h"
#include "tests/support/exact_distance.h"

namespace dualarm {
namespace {

constexpr std::uint64_t kSeed = 47;
constexpr std::array kKinds = {Kind::kCapsule, Kind::kBox, Kind::kCylinder};
constexpr double kSize = 8.0;  // m, of scenes of shapes of one metre

/// m. What rounding keeps a plane across nearest points from proving, see nearest_points.h.
constexpr double kProof = 3e-8 * kSize;

long double distance_of_point(const Eigen::Vector3d& point, const Shape& shape) {
  return exact_distance(Capsule{point, point, 0.0}, shape);
}

TEST(Separation, IsAProofThatNoTwoPointsAreCloser) {
  RandomShapes shapes(kSeed);
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", pair " << i);
    const auto [first, second] = shapes.pair(kKinds[i % 3], kKinds[i / 3 % 3], 1.0);
    const Eigen::Vector3d direction = shapes.direction();
    const double proven = separation(first, second, 5.0 * direction);
    ASSERT_NEAR(proven, static_cast<double>(proven_distance(first, second, direction)), 1e-13);
    for (int j = 0; j < 20; ++j) {
      ASSERT_GE((shapes.point_of(first) - shapes.point_of(second)).norm(), proven - 1e-13);
    }
  }
}

TEST(NearestPoints, BelongToTheShapesAndNoPointsAreCloserThanTheirLowerBound) {
  RandomShapes shapes(kSeed);
  double loosest = 0.0;
  for (int i = 0; i < 6000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", pair " << i);
    const auto [first, second] = shapes.pair(kKinds[i % 3], kKinds[i / 3 % 3], 1.0);
    const NearestPoints found = nearest_points(first, second, shapes.direction(), kSize);
    ASSERT_LE(distance_of_point(found.on_first, first), 1e-12L);
    ASSERT_LE(distance_of_point(found.on_second, second), 1e-12L);
    ASSERT_GE(found.upper_bound(), found.lower_bound);
    loosest = std::max(loosest, found.upper_bound() - found.lower_bound);
    for (int j = 0; j < 5; ++j) {
      ASSERT_GE((shapes.point_of(first) - shapes.point_of(second)).norm(), found.lower_bound - 1e-13);
    }
    if (found.lower_bound < 1e-6) continue;
    const Eigen::Vector3d across = found.on_first - found.on_second;
    ASSERT_GE(proven_distance(first, second, across), found.lower_bound - kProof);
  }
  EXPECT_LE(loosest, kProof);
}

TEST(NearestPoints, OfPolytopesAreTheirDistanceButForRounding) {
  RandomShapes shapes(kSeed);
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", pair " << i);
    const auto [first, second] = shapes.pair(Kind::kBox, Kind::kBox, 1.0);
    const NearestPoints found = nearest_points(first, second, shapes.direction(), kSize);
    const auto exact = static_cast<double>(exact_distance(first, second));
    ASSERT_NEAR(found.upper_bound(), exact, kProof);
    ASSERT_LE(found.lower_bound, exact + 1e-13);
    ASSERT_GE(found.lower_bound, exact - kProof);
  }
}

TEST(NearestPoints, StandAGuessThatPointsTheWrongWayOrAlongAFace) {
  Box first;
  first.half_extents = {1.0, 1.0, 0.0};
  Box second = first;
  second.pose.translation() = Eigen::Vector3d(0.0, 0.0, 2.0);
  for (const Eigen::Vector3d& guess :
       {Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1e-200, 0, 0)}) {
    const NearestPoints found = nearest_points(first, second, guess, kSize);
    EXPECT_NEAR(found.lower_bound, 2.0, 1e-12);
    EXPECT_NEAR(found.upper_bound(), 2.0, 1e-12);
  }
}

TEST(NearestPoints, OfShapesThatOverlapAreOneAndProveNothing) {
  Box first;
  first.half_extents = {1.0, 1.0, 1.0};
  const Cylinder second = {{0.5, 0.0, 0.0}, {3.0, 0.5, 0.5}, 0.7};
  const NearestPoints found = nearest_points(first, second, Eigen::Vector3d::UnitX(), kSize);
  EXPECT_EQ(found.lower_bound, 0.0);
  EXPECT_LE(found.upper_bound(), 1e-11);
}

}  // namespace
}  // namespace dualarm
