#include "core/passage/obstacle.h"

#include <gtest/gtest.h>

#include "tests/core/passage/scene_travellers.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

/// The lens of the paper's arms, seen between two joint positions (degrees).
struct Lens {
  Lens(Problem scene, std::array<double, 2> start, std::array<double, 2> goal)
      : problem(std::move(scene)),
        plane(problem, 0.0),
        obstacle(plane, {in_radians(start[0]), in_radians(start[1])}, {in_radians(goal[0]), in_radians(goal[1])},
                 *plane.slice_through(0, in_radians(30.0), in_radians(30.0))) {}

  /// The side of the ray that leaves the lens with one arm at a position.
  std::optional<int> side(int pinned, double position, bool runs_up) {
    for (const Interval& stretch : plane.slice(pinned, in_radians(position)).intervals()) {
      return obstacle.side_of({pinned, in_radians(position), stretch}, runs_up);
    }
    return std::nullopt;
  }

  Problem problem;
  ForbiddenPlane plane;
  Obstacle obstacle;
};

Problem lens_problem(double radius) { return paper_problem({10, 60}, {60, 10}, radius); }

TEST(Obstacle, PartsStartAndGoalOnBothSidesOfTheLensByEveryRayAtItsTip) {
  for (const double radius : {0.0, 1e-3, 0.2}) {
    Lens lens(lens_problem(radius), {10, 60}, {60, 10});
    const int closed = lens.obstacle.is_closed(0) ? 0 : 1;
    EXPECT_TRUE(lens.obstacle.is_closed(closed)) << radius;
    EXPECT_FALSE(lens.obstacle.is_closed(1 - closed)) << radius;
    EXPECT_EQ(lens.side(0, 48.0, true), 1 - closed) << radius;
    EXPECT_EQ(lens.side(1, 48.0, true), 1 - closed) << radius;
    EXPECT_EQ(lens.side(0, 20.0, true), 1 - closed) << radius;
    // Down from the lens leads to the border beside the corner that it closes: both are on one side of the goal.
    EXPECT_EQ(lens.side(0, 20.0, false), closed) << radius;
  }
}

TEST(Obstacle, IsKnownLessWhenTheBudgetRunsOut) {
  const Lens whole(lens_problem(0.1), {10, 60}, {60, 10});
  const Budget none({}, [] { return true; });
  const Obstacle part(whole.plane, {in_radians(10), in_radians(60)}, {in_radians(60), in_radians(10)},
                      *whole.plane.slice_through(0, in_radians(30.0), in_radians(30.0)), none);
  EXPECT_EQ(part.slices().size(), 1u);
  EXPECT_GT(whole.obstacle.slices().size(), 1u);
}

TEST(Obstacle, PartsNothingWhereStartAndGoalLieOnOneSideOfTheLens) {
  Lens lens(lens_problem(0.1), {10, 60}, {20, 70});
  const int closed = lens.obstacle.is_closed(0) ? 0 : 1;
  // A ray up from the tip does not lie between them; one that runs up between their positions does.
  EXPECT_EQ(lens.side(0, 48.0, true), closed);
  EXPECT_EQ(lens.side(0, 15.0, true), 1 - closed);
  EXPECT_EQ(lens.side(0, 30.0, true), closed);
}

TEST(Obstacle, BindsAGoalInThePocketBelowTheLens) {
  // The goal lies below the lens: every path to it passes below the lens at 30 degrees.
  Lens lens(lens_problem(0.0), {10, 60}, {20, 3});
  const int closed = lens.obstacle.is_closed(0) ? 0 : 1;
  EXPECT_EQ(lens.side(0, 30.0, false), 1 - closed);
  EXPECT_EQ(lens.side(0, 15.0, false), closed);
}

TEST(Obstacle, IsOpenOnBothSidesWhereItDoesNotTouchTheBorder) {
  Problem problem = lens_problem(0.1);
  for (Arm& arm : problem.arms) arm.joint_range = {-std::numbers::pi, std::numbers::pi};
  Lens lens(problem, {10, 60}, {60, 10});
  EXPECT_FALSE(lens.obstacle.is_closed(0));
  EXPECT_FALSE(lens.obstacle.is_closed(1));
  // Around the tip with both elbows up, or with both down.
  EXPECT_NE(lens.side(0, 48.0, true), lens.side(0, -48.0, false));
  EXPECT_EQ(lens.side(0, 48.0, true), lens.side(1, 48.0, true));
}

TEST(Obstacle, KnowsNoSideOfWhatIsNotConnectedToIt) {
  Lens lens(lens_problem(0.0), {10, 60}, {60, 10});
  EXPECT_EQ(lens.obstacle.side_of({0, in_radians(90.0), {in_radians(100.0), in_radians(110.0)}}, true), std::nullopt);
}

TEST(Obstacle, LiesInsideTheForbiddenSet) {
  Lens lens(lens_problem(0.05), {10, 60}, {60, 10});
  const ForbiddenSet forbidden(lens.problem, 0.0);
  for (const Slice& slice : lens.obstacle.slices()) {
    for (const double share : {0.001, 0.3, 0.999}) {
      const double other = slice.forbidden.lower + share * slice.forbidden.length();
      const double first = slice.pinned_arm == 0 ? slice.position : other;
      const double second = slice.pinned_arm == 0 ? other : slice.position;
      EXPECT_TRUE(forbidden.contains(first, second)) << first << " " << second;
    }
  }
}

}  // namespace
}  // namespace dualarm
