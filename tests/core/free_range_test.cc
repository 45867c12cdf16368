#include "core/free_range.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;

Object ball(const std::string& name, double direction, double radius) {
  FixedPlacement placement;
  placement.pose.translation() = Eigen::Vector3d(5.0 * std::cos(direction), 5.0 * std::sin(direction), 0.0);
  return {name, Capsule{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), radius}, placement};
}

/// Half the angle that a ball of radius 0.2 m at 5 m takes from an arm of radius 0.1 m that keeps 0.05 m.
const double kHalf = std::asin(0.35 / 5.0);

TEST(FreeRange, IsTheWholeJointRangeWhereNothingStands) {
  const Problem problem = paper_problem({60, 100}, {90, 120}, 0.1);
  const FreeRange free = free_range(problem, 0, 0.05);
  EXPECT_EQ(free.range, problem.arms[0].joint_range);
  EXPECT_TRUE(free.below.empty());
  EXPECT_TRUE(free.above.empty());
}

TEST(FreeRange, EndsAtTheNearestObjectsOnBothSides) {
  Problem problem = paper_problem({60, 100}, {90, 120}, 0.1);
  problem.objects = {ball("far", 0.1, 0.2), ball("near", 0.4, 0.2), ball("above", 2.0, 0.2), ball("beyond", 2.6, 0.2)};
  const FreeRange free = free_range(problem, 0, 0.05);
  EXPECT_NEAR(free.range.lower, 0.4 + kHalf, 1e-12);
  EXPECT_NEAR(free.range.upper, 2.0 - kHalf, 1e-12);
  EXPECT_EQ(free.below, "near");
  EXPECT_EQ(free.above, "above");
  EXPECT_EQ(free.below_by, "arm1");
}

TEST(FreeRange, KnowsThatACarriedBeamReachesFurther) {
  Problem problem = paper_problem({60, 100}, {90, 120}, 0.1);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(5.0, 0.0, 0.0);
  problem.objects = {ball("above", 2.3, 0.2),
                     {"beam", Capsule{{0, 0, 0}, {0, 1.0, 0}, 0.1}, AttachedPlacement{0, pose, 0.1}}};
  const FreeRange free = free_range(problem, 0, 0.05);
  EXPECT_LT(free.range.upper, 2.3 - std::atan2(1.0, 5.0));
  EXPECT_EQ(free.above_by, "beam");
}

TEST(FreeRange, CoversEveryTurnOfARangeOfMoreThanOne) {
  Problem problem = paper_problem({60, 100}, {90, 120}, 0.1);
  problem.arms[0].joint_range = {-3.0 * kPi, 4.0 * kPi};
  problem.objects = {ball("post", 2.0, 0.2)};
  const FreeRange free = free_range(problem, 0, 0.05);
  EXPECT_NEAR(free.range.lower, 2.0 - 2.0 * kPi + kHalf, 1e-12);
  EXPECT_NEAR(free.range.upper, 2.0 - kHalf, 1e-12);
}

TEST(FreeRange, IsLeftWholeWhereAnObjectStandsBetweenStartAndGoal) {
  Problem problem = paper_problem({60, 100}, {90, 120}, 0.1);
  problem.objects = {ball("post", 1.3, 0.2)};
  EXPECT_EQ(free_range(problem, 0, 0.05).range, problem.arms[0].joint_range);
}

}  // namespace
}  // namespace dualarm
