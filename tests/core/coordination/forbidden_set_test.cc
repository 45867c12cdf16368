#include "core/coordination/forbidden_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/clearance.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr Interval kHalfTurn = {0.0, kPi};

/// Smallest distance between anything of arm 1 and anything of arm 2, by FCL.
double fcl_distance(const Problem& problem, double theta1, double theta2) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Body& first : moving_bodies(problem, 0)) {
    for (const Body& second : moving_bodies(problem, 1)) {
      const Shape a = placed(first.shape, link_pose(problem.arms[0].base, theta1));
      const Shape b = placed(second.shape, link_pose(problem.arms[1].base, theta2));
      smallest = std::min(smallest, clearance(a, b).distance);
    }
  }
  return smallest;
}

TEST(ForbiddenSet, AgreesWithFclOnRandomScenesOfAnyHeadingHeightAndSense) {
  constexpr unsigned kSeed = 42;
  SCOPED_TRACE(kSeed);
  std::mt19937 random(kSeed);
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  int collisions = 0;
  for (int scene = 0; scene < 400; ++scene) {
    Problem problem = random_problem(scene);
    for (Arm& arm : problem.arms) {
      arm.base.heading = draw(-kPi, kPi);
      arm.base.rotation = draw(0.0, 1.0) < 0.5 ? Rotation::kClockwise : Rotation::kCounterclockwise;
      arm.base.position.z() = draw(-0.1, 0.1);
    }
    const double length = problem.arms[0].length;
    Eigen::Isometry3d pose = Eigen::Translation3d(draw(0.3, 1.2) * length, draw(-0.3, 0.3) * length, draw(-0.1, 0.1)) *
                             Eigen::AngleAxisd(draw(-kPi, kPi), Eigen::Vector3d::UnitZ());
    problem.objects = {
        {"load", Capsule{{-0.1 * length, 0, 0}, {0.1 * length, 0, 0}, 0.05}, AttachedPlacement{0, pose, 0.0}}};
    const double demanded = draw(0.0, 0.1);
    const ForbiddenSet forbidden(problem, demanded);
    for (int i = 0; i < 100; ++i) {
      const double theta1 = draw(-kPi, kPi);
      const double theta2 = draw(-kPi, kPi);
      const double excess = fcl_distance(problem, theta1, theta2) - demanded;
      if (std::abs(excess) < 1e-5) continue;
      collisions += excess < 0.0 ? 1 : 0;
      ASSERT_EQ(forbidden.contains(theta1, theta2), excess < 0.0) << "scene " << scene << " excess " << excess;
    }
  }
  EXPECT_GT(collisions, 500);
}

TEST(ForbiddenSet, SliceOverAnIntervalHoldsEverySliceOfIt) {
  const Problem problem = paper_problem({30, 60}, {60, 30}, 0.2);
  const ForbiddenSet forbidden(problem, 0.05);
  for (double theta1 = 0.0; theta1 < 1.0; theta1 += 0.05) {
    const IntervalSet over = forbidden.slice_over({theta1, theta1 + 0.05}, kHalfTurn);
    for (int i = 0; i <= 10; ++i) {
      for (const Interval& piece : forbidden.slice(theta1 + 0.005 * i, kHalfTurn).intervals()) {
        EXPECT_TRUE(over.covers(piece)) << theta1;
      }
    }
  }
}

TEST(ForbiddenSet, LetsArmsInPlanesFarApartPass) {
  Problem problem = paper_problem({30, 60}, {60, 30}, 0.2);
  problem.arms[1].base.position.z() = 0.41;
  EXPECT_FALSE(ForbiddenSet(problem, 0.0).contains(0.4, 0.3));
  EXPECT_TRUE(ForbiddenSet(problem, 0.02).contains(0.4, 0.3));
}

TEST(PaperSet, ForbidsWhereArmOneStandsClearAboveArmTwo) {
  // theory.md, section 2: at (60, 30) degrees the paper's set says collision, the true one does not.
  Problem problem = paper_problem({30, 60}, {60, 30}, 1e-6);
  EXPECT_FALSE(ForbiddenSet(problem, 0.0).contains(kPi / 3.0, kPi / 6.0));
  problem.options.region_model = RegionModel::kPaper;
  EXPECT_TRUE(ForbiddenSet(problem, 0.0).contains(kPi / 3.0, kPi / 6.0));
}

TEST(PaperSet, IsTheOneOfThePapersInequalities) {
  Problem problem = paper_problem({30, 60}, {60, 30}, 1e-6);
  problem.options.region_model = RegionModel::kPaper;
  const ForbiddenSet forbidden(problem, 0.0);
  for (double theta1 = 0.005; theta1 < 3.1; theta1 += 0.02) {
    for (double theta2 = 0.005; theta2 < 3.1; theta2 += 0.02) {
      const bool in_paper_set = 6.0 * std::cos(theta1) + 6.0 * std::cos(theta2) >= 8.0 &&
                                std::atan2(6.0 * std::sin(theta1), 8.0 - 6.0 * std::cos(theta1)) >= theta2;
      ASSERT_EQ(forbidden.contains(theta1, theta2), in_paper_set) << theta1 << " " << theta2;
    }
  }
}

TEST(PaperSet, SliceOverAnIntervalHoldsEverySliceOfIt) {
  Problem problem = paper_problem({30, 60}, {60, 30}, 1e-6);
  problem.options.region_model = RegionModel::kPaper;
  const ForbiddenSet forbidden(problem, 0.0);
  for (double theta1 = 0.0; theta1 < 1.4; theta1 += 0.05) {
    const IntervalSet over = forbidden.slice_over({theta1, theta1 + 0.05}, kHalfTurn);
    for (int i = 0; i <= 10; ++i) {
      for (const Interval& piece : forbidden.slice(theta1 + 0.005 * i, kHalfTurn).intervals()) {
        EXPECT_TRUE(over.covers({piece.lower, piece.upper - 1e-12})) << theta1;
      }
    }
  }
}

TEST(BlockedPositions, AreThoseAtWhichFclFindsTheObject) {
  Base base;
  base.position = {1.0, -0.5, 0.2};
  base.heading = 0.8;
  base.rotation = Rotation::kClockwise;
  const Capsule link = {{0, 0, 0}, {2.0, 0, 0}, 0.1};
  const Capsule wall = {{2.0, 0.5, 0.25}, {2.5, -0.5, 0.25}, 0.15};
  const IntervalSet blocked = blocked_positions(base, link, wall, 0.03, {-kPi, kPi});
  EXPECT_FALSE(blocked.empty());
  for (double theta = -3.0; theta < 3.0; theta += 0.001) {
    const double excess = clearance(placed(link, link_pose(base, theta)), wall).distance - 0.03;
    if (std::abs(excess) < 1e-6) continue;
    EXPECT_EQ(blocked.contains(theta), excess < 0.0) << theta;
  }
}

}  // namespace
}  // namespace dualarm
