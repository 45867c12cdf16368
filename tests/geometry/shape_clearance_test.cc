#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "geometry/chain.h"
#include "geometry/clearance.h"
#include "geometry/support.h"
#include "tests/geometry/random_shapes.h"
#include "tests/support/exact_distance.h"

namespace dualarm {
namespace {

constexpr std::uint64_t kSeed = 41;
constexpr int kPairsOfPolytopes = 1000;        // a kind and size, 30 us each
constexpr int kPairsOfCylinders = 2000;        // judged by planes, 10 us each
constexpr int kSearchedPairsOfCylinders = 12;  // 7 ms each

// m per m of the scene. Almost in touch, two nearest points leave a direction only as sharp as rounding is small beside
// their distance: the plane across them proves less, most where the distance is the root of the machine's precision.
constexpr double kUnderstatedPerLength = 3e-8;
constexpr double kUnderstatedFloor = 1e-12;  // m

// What the long double searches leave, m per m.
constexpr long double kSearchError = 1e-12L;

double scene_size(const Shape& first, const Shape& second) {
  return bounding_radius(first) + bounding_radius(second) + (centre(first) - centre(second)).norm();
}

double most_understated(const Shape& first, const Shape& second) {
  return kUnderstatedFloor + kUnderstatedPerLength * scene_size(first, second) + rounding_of_rim(first) +
         rounding_of_rim(second);
}

/// The closed form of two capsules is off either way.
double most_understated_by_axes(const Shape& first, const Shape& second) {
  return std::max(most_understated(first, second), clearance_error(first, second));
}

double rounding(const Shape& shape) {
  const auto* capsule = std::get_if<Capsule>(&shape);
  return capsule != nullptr ? capsule->radius : 0.0;
}

long double distance_of_point(const Eigen::Vector3d& point, const Shape& shape) {
  return exact_distance(Capsule{point, point, 0.0}, shape);
}

using Kinds = std::pair<Kind, Kind>;

class ShapeClearance : public testing::TestWithParam<std::tuple<Kinds, double>> {
 protected:
  std::pair<Shape, Shape> next() {
    const auto& [kinds, size] = GetParam();
    return shapes_.pair(kinds.first, kinds.second, size);
  }

  RandomShapes shapes_{kSeed};
};

using ClearanceOfPolytopes = ShapeClearance;

TEST_P(ClearanceOfPolytopes, IsTheExactDistanceButForItsError) {
  double most_over = -1.0;
  double most_under = 0.0;
  for (int i = 0; i < kPairsOfPolytopes; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", pair " << i);
    const auto [first, second] = next();
    const auto error = static_cast<double>(clearance(first, second).distance - exact_distance(first, second));
    ASSERT_LE(error, clearance_error(first, second));
    ASSERT_GE(error, -most_understated_by_axes(first, second));
    most_over = std::max(most_over, error);
    most_under = std::max(most_under, -error / scene_size(first, second));
  }
  RecordProperty("most_over_m", std::to_string(most_over * 1e9) + "e-9");
  RecordProperty("most_under_m_per_m", std::to_string(most_under * 1e12) + "e-12");
}

INSTANTIATE_TEST_SUITE_P(Metres, ClearanceOfPolytopes,
                         testing::Combine(testing::Values(Kinds(Kind::kCapsule, Kind::kBox),
                                                          Kinds(Kind::kBox, Kind::kBox)),
                                          testing::Values(0.01, 1.0, 6.0, 60.0, 1000.0)));

using ClearanceOfCylinders = ShapeClearance;

TEST_P(ClearanceOfCylinders, IsTheDistanceFoundByNestedSearchButForItsError) {
  for (int i = 0; i < kSearchedPairsOfCylinders; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", pair " << i);
    const auto [first, second] = next();
    const long double error = clearance(first, second).distance - exact_distance(first, second);
    const long double search_error = kSearchError * scene_size(first, second);
    ASSERT_LE(error, clearance_error(first, second) + search_error);
    ASSERT_GE(error, -most_understated_by_axes(first, second) - search_error);
  }
}

/// Nearest points are proof from above, the plane across them from below; no search has to be believed.
TEST_P(ClearanceOfCylinders, IsProvenByItsOwnNearestPoints) {
  double most_over = -1.0;
  double most_under = 0.0;
  int overlaps = 0;
  for (int i = 0; i < kPairsOfCylinders; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", pair " << i);
    const auto [first, second] = next();
    const Clearance found = clearance(first, second);
    const double size = scene_size(first, second);
    const bool overlap = found.distance + rounding(first) + rounding(second) <= 0.0;
    overlaps += overlap ? 1 : 0;
    // Of two axes the closed form may miss the points, by as much as its error: another test judges those.
    if (clearance_error(first, second) > 1e-7) continue;
    const Eigen::Vector3d across = found.point_on_first - found.point_on_second;
    ASSERT_LE(distance_of_point(found.point_on_first, first), 1e-13 * size + 1e-13 + rounding_of_rim(first));
    ASSERT_LE(distance_of_point(found.point_on_second, second), 1e-13 * size + 1e-13 + rounding_of_rim(second));
    ASSERT_LE(overlap ? across.norm() : across.norm() - found.distance,
              (found.distance < 0.0 ? 2.0 * rounding(first) + 2.0 * rounding(second) : 0.0) +
                  most_understated(first, second));
    if (found.distance <= most_understated(first, second)) continue;
    const long double error = found.distance - proven_distance(first, second, across);
    // The points are rounded, so that points almost in touch have no sharp direction between them.
    ASSERT_LE(error, clearance_error(first, second) + 1e-15 * size * size / found.distance);
    most_over = std::max(most_over, static_cast<double>(error));
    most_under = std::max(most_under, (across.norm() - found.distance) / size);
  }
  EXPECT_GT(overlaps, 0);
  EXPECT_LT(overlaps, kPairsOfCylinders / 2);
  RecordProperty("most_over_m", std::to_string(most_over * 1e9) + "e-9");
  RecordProperty("most_under_m_per_m", std::to_string(most_under * 1e12) + "e-12");
}

INSTANTIATE_TEST_SUITE_P(Metres, ClearanceOfCylinders,
                         testing::Combine(testing::Values(Kinds(Kind::kCapsule, Kind::kCylinder),
                                                          Kinds(Kind::kBox, Kind::kCylinder),
                                                          Kinds(Kind::kCylinder, Kind::kCylinder)),
                                          testing::Values(0.01, 1.0, 6.0, 60.0, 1000.0)));

Box box_at(const Eigen::Vector3d& middle, const Eigen::Vector3d& half) {
  Box box;
  box.pose.translation() = middle;
  box.half_extents = half;
  return box;
}

TEST(ShapeClearanceByHand, OfFacesEdgesAndCorners) {
  const Box cube = box_at(Eigen::Vector3d::Zero(), {1.0, 1.0, 1.0});
  EXPECT_NEAR(clearance(cube, box_at({5.0, 0.5, 0.0}, {1.0, 1.0, 1.0})).distance, 3.0, 1e-9);
  EXPECT_NEAR(clearance(cube, box_at({5.0, 6.0, 0.0}, {1.0, 1.0, 1.0})).distance, 5.0, 1e-9);
  EXPECT_NEAR(clearance(cube, Capsule{{3.0, 3.0, 2.0}, {3.0, 3.0, 2.0}, 0.5}).distance, 2.5, 1e-9);
  EXPECT_NEAR(clearance(cube, Cylinder{{0.0, 0.0, 3.0}, {0.0, 0.0, 4.0}, 1.5}).distance, 2.0, 1e-9);
  EXPECT_NEAR(clearance(cube, Cylinder{{4.0, 0.0, -1.0}, {4.0, 0.0, 1.0}, 0.5}).distance, 2.5, 1e-9);
  EXPECT_NEAR(
      clearance(Cylinder{{0.0, 0.0, 0.0}, {0.0, 0.0, 2.0}, 1.0}, Cylinder{{5.0, 0.0, 5.0}, {5.0, 0.0, 6.0}, 1.0})
          .distance,
      std::hypot(3.0, 3.0), 1e-9);
}

TEST(ShapeClearanceByHand, IsNotPositiveOnOverlapAndTakesTheRoundingOff) {
  const Box cube = box_at(Eigen::Vector3d::Zero(), {1.0, 1.0, 1.0});
  EXPECT_EQ(clearance(cube, cube).distance, 0.0);
  EXPECT_NEAR(clearance(cube, box_at({2.0, 0.0, 0.0}, {1.0, 1.0, 1.0})).distance, 0.0, 1e-12);
  EXPECT_NEAR(clearance(cube, Capsule{{0.5, 0.0, 0.0}, {4.0, 0.0, 0.0}, 0.25}).distance, -0.25, 1e-9);
  EXPECT_NEAR(clearance(cube, Capsule{{1.1, 0.0, 0.0}, {4.0, 0.0, 0.0}, 0.25}).distance, -0.15, 1e-9);
  const Cylinder can = {{0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}, 1.0};
  EXPECT_EQ(clearance(can, can).distance, 0.0);
  EXPECT_EQ(clearance(can, cube).distance, 0.0);
}

TEST(ShapeClearanceByHand, AWaferOfACylinderIsTheBallAroundItAndADiscOfSomeThicknessIsADisc) {
  const Box cube = box_at({0.0, 0.0, 3.0}, {1.0, 1.0, 1.0});
  EXPECT_NEAR(clearance(Cylinder{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.5}, cube).distance, 1.5, 1e-9);
  const double thin = 2.0 * kShortestCylinder;
  EXPECT_NEAR(clearance(Cylinder{{0.0, 0.0, -thin}, {0.0, 0.0, 0.0}, 0.5}, cube).distance, 2.0, 1e-9);
}

TEST(ShapeClearanceByHand, OfWhatHasOnlyOnePointWithItselfIsNothing) {
  const Box point = box_at({1.0, 2.0, 3.0}, Eigen::Vector3d::Zero());
  const Cylinder disc = {{1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}, 0.0};
  const std::array<Shape, 3> specks = {point, disc, Capsule{{1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}, 0.0}};
  for (const Shape& first : specks) {
    for (const Shape& second : specks) EXPECT_NEAR(clearance(first, second).distance, 0.0, 1e-15);
  }
}

TEST(ShapeClearanceProperty, DoesNotCareForTheOrderOrACommonDisplacement) {
  RandomShapes shapes(kSeed);
  constexpr std::array kKinds = {Kind::kCapsule, Kind::kBox, Kind::kCylinder};
  const Eigen::Isometry3d pose = link_pose({{3.0, -2.0, 1.0}, 0.4, Rotation::kClockwise}, 1.3);
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", pair " << i);
    const auto [first, second] = shapes.pair(kKinds[i % 3], kKinds[i / 3 % 3], 2.0);
    const double found = clearance(first, second).distance;
    const double room = clearance_error(first, second) + most_understated_by_axes(first, second);
    ASSERT_NEAR(clearance(second, first).distance, found, room);
    ASSERT_NEAR(clearance(placed(first, pose), placed(second, pose)).distance, found, room);
  }
}

}  // namespace
}  // namespace dualarm
