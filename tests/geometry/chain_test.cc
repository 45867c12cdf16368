#include "geometry/chain.h"

#include <gtest/gtest.h>

#include <numbers>

#include "geometry/support.h"
#include "tests/geometry/random_shapes.h"

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Chain, TheLinkPointsAlongTheHeadingAtZero) {
  const Base base = {{1.0, 2.0, 3.0}, kPi / 2.0, Rotation::kCounterclockwise};
  const Eigen::Vector3d tip = link_pose(base, 0.0) * Eigen::Vector3d(6.0, 0.0, 0.0);
  EXPECT_TRUE(tip.isApprox(Eigen::Vector3d(1.0, 8.0, 3.0), 1e-15));
}

TEST(Chain, ArmOneOfThePaperRisesCounterclockwise) {
  const Eigen::Vector3d tip = link_pose(Base{}, kPi / 3.0) * Eigen::Vector3d(6.0, 0.0, 0.0);
  EXPECT_TRUE(tip.isApprox(Eigen::Vector3d(3.0, 6.0 * std::sin(kPi / 3.0), 0.0), 1e-15));
}

TEST(Chain, ArmTwoOfThePaperRisesClockwise) {
  const Base base = {{8.0, 0.0, 0.0}, kPi, Rotation::kClockwise};
  const Eigen::Vector3d tip = link_pose(base, kPi / 3.0) * Eigen::Vector3d(6.0, 0.0, 0.0);
  EXPECT_TRUE(tip.isApprox(Eigen::Vector3d(5.0, 6.0 * std::sin(kPi / 3.0), 0.0), 1e-15));
}

TEST(Chain, TheFrameStaysRightHandedAndUprightInEitherSense) {
  for (const Rotation rotation : {Rotation::kCounterclockwise, Rotation::kClockwise}) {
    const Eigen::Isometry3d pose = link_pose({{0.0, 0.0, 0.0}, 0.7, rotation}, 1.1);
    EXPECT_NEAR(pose.linear().determinant(), 1.0, 1e-15);
    EXPECT_TRUE((pose.linear() * Eigen::Vector3d::UnitZ()).isApprox(Eigen::Vector3d::UnitZ(), 1e-15));
  }
}

TEST(Chain, PlacingMovesBothEndsAndKeepsTheRadius) {
  const Eigen::Isometry3d pose = link_pose({{1.0, 0.0, 0.5}, 0.0, Rotation::kCounterclockwise}, kPi / 2.0);
  const Capsule capsule = placed(Capsule{{1.0, 0.0, 0.0}, {2.0, 0.0, 0.1}, 0.25}, pose);
  EXPECT_TRUE(capsule.start.isApprox(Eigen::Vector3d(1.0, 1.0, 0.5), 1e-15));
  EXPECT_TRUE(capsule.end.isApprox(Eigen::Vector3d(1.0, 2.0, 0.6), 1e-15));
  EXPECT_EQ(capsule.radius, 0.25);
}

TEST(Chain, PlacingAnyShapeKeepsItsKindAndMovesEachOfItsPoints) {
  constexpr std::uint64_t kSeed = 59;
  RandomShapes shapes(kSeed);
  for (int i = 0; i < 600; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", shape " << i);
    const Shape shape = shapes.shape(static_cast<Kind>(i % 3), 2.0);
    const Eigen::Isometry3d pose = shapes.pose(3.0);
    const Shape moved = placed(shape, pose);
    ASSERT_EQ(moved.index(), shape.index());
    for (int j = 0; j < 10; ++j) {
      const Eigen::Vector3d direction = shapes.direction();
      const double reached = direction.dot(farthest_point(moved, direction));
      const double expected = direction.dot(pose * farthest_point(shape, pose.linear().transpose() * direction));
      ASSERT_NEAR(reached, expected, 1e-13 + rounding_of_rim(shape));
    }
  }
}

}  // namespace
}  // namespace dualarm
