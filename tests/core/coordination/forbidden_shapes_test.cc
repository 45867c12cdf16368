// Slices of the forbidden set of all kinds of bodies against FCL's distances.
#include <gtest/gtest.h>

#include <cmath>

#include "core/coordination/forbidden_set.h"
#include "geometry/chain.h"
#include "geometry/clearance.h"
#include "tests/core/coordination/random_shape.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr Interval kTurn = {-kPi, kPi};
constexpr int kScenes = 200;
/// m. What FCL's distance of capsules may be off by.
constexpr double kFclError = 1e-6;

/// Two arms anywhere, each with a load, of which one is of the kind asked for.
Problem scene_with(ShapeKind kind, std::uint64_t seed) {
  Dice dice(seed);
  Problem problem = random_problem(seed);
  for (Arm& arm : problem.arms) {
    arm.base.heading = dice.between(-kPi, kPi);
    arm.base.rotation = dice.happens(0.5) ? Rotation::kClockwise : Rotation::kCounterclockwise;
    arm.base.position.z() = dice.between(-0.2, 0.2);
  }
  problem.objects.clear();
  for (int arm = 0; arm < kArmCount; ++arm) {
    const double size = problem.arms[arm].length;
    const ShapeKind of_load = arm == static_cast<int>(seed % 2) ? kind : kShapeKinds[dice.one_of(10)];
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() =
        size * Eigen::Vector3d(dice.between(0.2, 1.1), dice.between(-0.3, 0.3), dice.between(-0.3, 0.3));
    pose.linear() = Eigen::AngleAxisd(dice.between(-kPi, kPi), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    problem.objects.push_back(
        {"load " + std::to_string(arm), random_shape(of_load, size, dice), AttachedPlacement{arm, pose, 0.0}});
  }
  problem.options.clearance = dice.happens(0.2) ? 0.0 : dice.between(0.0, 0.1);
  return problem;
}

double fcl_distance(const Problem& problem, double theta1, double theta2) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Body& first : moving_bodies(problem, 0)) {
    for (const Body& second : moving_bodies(problem, 1)) {
      smallest = std::min(smallest, clearance(placed(first.shape, link_pose(problem.arms[0].base, theta1)),
                                              placed(second.shape, link_pose(problem.arms[1].base, theta2)))
                                        .distance);
    }
  }
  return smallest;
}

class ForbiddenShapes : public ::testing::TestWithParam<ShapeKind> {};

TEST_P(ForbiddenShapes, AreForbiddenWhereFclSaysSo) {
  int collisions = 0;
  int free = 0;
  int closed = 0;
  for (int scene = 0; scene < kScenes; ++scene) {
    SCOPED_TRACE(scene);
    const Problem problem = scene_with(GetParam(), scene);
    const ForbiddenSet forbidden(problem, problem.options.clearance);
    Dice dice(scene + 1000);
    const double theta1 = dice.between(-kPi, kPi);
    const IntervalSet slice = forbidden.slice(theta1, kTurn);
    for (int i = 0; i < 150; ++i) {
      const double theta2 = dice.between(-kPi, kPi);
      const double excess = fcl_distance(problem, theta1, theta2) - problem.options.clearance;
      if (std::abs(excess) < kFclError) continue;
      ++(excess < 0.0 ? collisions : free);
      if (excess < 0.0) {
        ASSERT_TRUE(slice.contains(theta2)) << theta2 << " excess " << excess;
      } else {
        closed += slice.contains(theta2) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(collisions, 500);
  EXPECT_GT(free, 500);
  EXPECT_EQ(closed, 0);
}

TEST_P(ForbiddenShapes, EndWhereTheDistanceIsTheDemandedOne) {
  int ends = 0;
  for (int scene = 0; scene < kScenes; ++scene) {
    SCOPED_TRACE(scene);
    const Problem problem = scene_with(GetParam(), scene);
    const ForbiddenSet forbidden(problem, problem.options.clearance);
    const double theta1 = Dice(scene + 1000).between(-kPi, kPi);
    for (const Interval& piece : forbidden.slice(theta1, kTurn).intervals()) {
      for (const double theta2 : {piece.lower, piece.upper}) {
        if (std::abs(theta2) == kPi) continue;
        ++ends;
        EXPECT_NEAR(fcl_distance(problem, theta1, theta2), problem.options.clearance, kFclError);
      }
    }
  }
  EXPECT_GT(ends, 50);
}

TEST_P(ForbiddenShapes, AreAllThereInASliceOverAnInterval) {
  for (int scene = 0; scene < kScenes; ++scene) {
    SCOPED_TRACE(scene);
    const Problem problem = scene_with(GetParam(), scene);
    const ForbiddenSet forbidden(problem, problem.options.clearance);
    Dice dice(scene + 2000);
    const double theta1 = dice.between(-kPi, kPi);
    const Interval over = {theta1, theta1 + dice.between(0.0, 0.2)};
    const IntervalSet wide = forbidden.slice_over(over, kTurn);
    for (int i = 0; i <= 4; ++i) {
      const double inside = over.lower + 0.25 * i * over.length();
      for (const Interval& piece : forbidden.slice(inside, kTurn).intervals()) {
        EXPECT_TRUE(wide.covers(piece, 1e-9)) << inside << ": " << piece.lower << " " << piece.upper;
      }
    }
  }
}

TEST_P(ForbiddenShapes, BlockPositionsWhereTheyStandStill) {
  int collisions = 0;
  for (int scene = 0; scene < kScenes; ++scene) {
    SCOPED_TRACE(scene);
    Dice dice(scene);
    const Problem problem = scene_with(GetParam(), scene);
    const Base& base = problem.arms[0].base;
    const Body moving = moving_bodies(problem, 0)[dice.one_of(2)];
    const double length = problem.arms[0].length;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = base.position + length * Eigen::Vector3d(dice.between(-1.2, 1.2), dice.between(-1.2, 1.2),
                                                                  dice.between(-0.3, 0.3));
    const Shape fixed = placed(random_shape(GetParam(), length, dice), pose);
    const double demanded = problem.options.clearance;
    const IntervalSet blocked = blocked_positions(base, moving.shape, fixed, demanded, kTurn);
    for (int i = 0; i < 150; ++i) {
      const double theta = dice.between(-kPi, kPi);
      const double excess = clearance(placed(moving.shape, link_pose(base, theta)), fixed).distance - demanded;
      if (std::abs(excess) < kFclError) continue;
      collisions += excess < 0.0 ? 1 : 0;
      ASSERT_EQ(blocked.contains(theta), excess < 0.0) << theta << " excess " << excess;
    }
  }
  EXPECT_GT(collisions, 500);
}

INSTANTIATE_TEST_SUITE_P(OfEveryKind, ForbiddenShapes, ::testing::ValuesIn(kShapeKinds),
                         [](const auto& kind) { return name_of(kind.param); });

}  // namespace
}  // namespace dualarm
