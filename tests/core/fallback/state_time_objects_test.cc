// The search among objects that move by themselves.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/core/fallback/schedule_check.h"
#include "tests/core/fallback/searching.h"

namespace dualarm {
namespace {

/// A ball that stands somewhere (m) until a time (s), then leaves upwards within half a second.
Object ball_until(const std::string& name, const Eigen::Vector3d& there, double time) {
  MovingPlacement leaves;
  leaves.track =
      PoseTrack({{time, Eigen::Isometry3d(Eigen::Translation3d(there))},
                 {time + 0.5, Eigen::Isometry3d(Eigen::Translation3d(there + Eigen::Vector3d(0.0, 4.0, 0.0)))}});
  return {name, Capsule{{0, 0, 0}, {0, 0, 0}, 0.2}, leaves};
}

/// A ball stands in arm 1's way from 60 to 90 degrees until a time (s).
Problem blocked_until(double time) {
  Problem problem = paper_problem({60.0, 100.0}, {90.0, 120.0});
  const Eigen::Vector3d there = 5.0 * Eigen::Vector3d(std::cos(75.0 * kDegree), std::sin(75.0 * kDegree), 0.0);
  problem.objects = {ball_until("ball", there, time)};
  return problem;
}

TEST(SearchStateTime, WaitsForAnObjectToLeaveAndNotMuchLonger) {
  for (const double blocked : {1.0, 3.0}) {
    for (int seed = 0; seed < 5; ++seed) {
      SCOPED_TRACE(testing::Message() << "blocked for " << blocked << " s, seed " << seed);
      Problem problem = blocked_until(blocked);
      problem.options.seed = seed;
      const ArmSystems arms(problem);
      const SearchResult result = search(problem, arms, 3000);
      ASSERT_TRUE(result.schedule);
      expect_consistent(problem, *result.schedule, result.duration);
      EXPECT_GE(smallest_gap(problem, *result.schedule, result.duration, kInstants), kClearance);
      EXPECT_GT(result.duration, blocked);
      EXPECT_LT(result.duration, blocked + 1.5);
    }
  }
}

TEST(SearchStateTime, LetsBothArmsWaitWhereBothAreBlocked) {
  for (int seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Problem problem = blocked_until(2.0);
    const Eigen::Vector3d there(8.0 - 5.0 * std::cos(110.0 * kDegree), 5.0 * std::sin(110.0 * kDegree), 0.0);
    problem.objects.push_back(ball_until("other ball", there, 2.0));
    problem.options.seed = seed;
    const ArmSystems arms(problem);
    const SearchResult result = search(problem, arms, 3000);
    ASSERT_TRUE(result.schedule);
    expect_consistent(problem, *result.schedule, result.duration);
    EXPECT_GE(smallest_gap(problem, *result.schedule, result.duration, kInstants), kClearance);
    EXPECT_GT(result.duration, 2.0);
    EXPECT_LT(result.duration, 2.0 + 1.5);
    for (const auto& motions : *result.schedule) {
      EXPECT_GT(motions.back().start_time + motions.back().profile.duration(), 2.0);
    }
  }
}

TEST(SearchStateTime, PassesBeforeAnObjectComes) {
  Problem problem = paper_problem({60.0, 100.0}, {90.0, 120.0});
  MovingPlacement comes;
  comes.track = PoseTrack({{1.2, Eigen::Isometry3d(Eigen::Translation3d(2.6, 9.0, 0.0))},
                           {1.6, Eigen::Isometry3d(Eigen::Translation3d(2.6, 4.5, 0.0))}});
  problem.objects = {{"ball", Capsule{{0, 0, 0}, {0, 0, 0}, 0.2}, comes}};
  const ArmSystems arms(problem);
  const SearchResult result = search(problem, arms, 3000);
  ASSERT_TRUE(result.schedule);
  EXPECT_LT(result.duration, 1.5);
  EXPECT_GE(smallest_gap(problem, *result.schedule, result.duration, kInstants), kClearance);
}

TEST(SearchStateTime, ArrivesForGoodOnlyWhenNothingPassesTheGoalAnyMore) {
  Problem problem = paper_problem({60.0, 100.0}, {90.0, 120.0});
  MovingPlacement passes;
  passes.track = PoseTrack({{1.8, Eigen::Isometry3d(Eigen::Translation3d(-4.0, 5.0, 0.0))},
                            {2.8, Eigen::Isometry3d(Eigen::Translation3d(6.0, 13.0, 0.0))}});
  problem.objects = {{"ball", Capsule{{0, 0, 0}, {0, 0, 0}, 0.2}, passes}};
  problem.arms[0].length = 9.0;
  problem.arms[1].base.position.x() = 20.0;
  const ArmSystems arms(problem);
  const Budget unlimited;
  const double left = ClearanceProof(problem, kClearance, unlimited).free_from(0, problem.tasks[0].goal.position);
  ASSERT_GT(left, 2.1);
  const SearchResult result = search(problem, arms, 4000);
  ASSERT_TRUE(result.schedule);
  expect_consistent(problem, *result.schedule, result.duration);
  EXPECT_GE(result.duration, left);
  EXPECT_LT(result.duration, left + 0.6);
}

}  // namespace
}  // namespace dualarm
