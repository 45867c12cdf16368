// Plans among moving objects.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/coordination/diagram.h"
#include "core/coordination/moving_objects.h"
#include "core/coordination/start_times.h"
#include "core/planner.h"
#include "tests/core/coordination/random_traffic.h"
#include "tests/core/planner_answers.h"
#include "tests/support/independent_check.h"

namespace dualarm {
namespace {

/// s. The planning margin of 1e-4 m costs this much at most in the scenes that are compared.
constexpr double kMarginCosts = 1e-2;

/// The best pair of start times of the fastest motions at the demanded clearance.
std::optional<StartTimes> best_pair(const TrafficScene& scene) {
  const Problem& problem = scene.problem;
  const double clearance = problem.options.clearance;
  const Interval ever = {0.0, std::numeric_limits<double>::infinity()};
  const auto starts = [&](int arm) {
    return forbidden_starts(scene.motions[arm], problem.arms[arm].base, moving_bodies(problem, arm),
                            tracked_bodies(problem), clearance, Budget())
        ->complement(ever);
  };
  const IntervalSet delays =
      *forbidden_delays(ForbiddenSet(problem, clearance), scene.motions[0], scene.motions[1], Budget());
  return best_start_times({delays.complement({-ever.upper, ever.upper}), starts(0), starts(1)},
                          timing_of(scene.motions[0]), timing_of(scene.motions[1]), ever.upper);
}

TEST(PlanAmongMovingObjects, BeginsAtTheBestPairOfStartTimesAndIsProven) {
  int plans = 0;
  int waits = 0;
  int slower = 0;
  int lost = 0;
  for (int seed = 0; seed < 160; ++seed) {
    SCOPED_TRACE(seed);
    TrafficScene scene = random_traffic_scene(seed);
    if (scene.motions.size() != 2) continue;
    scene.problem.options.methods = {Method::kSimultaneous, Method::kDelay, Method::kPassage};
    const auto best = best_pair(scene);
    const Outcome outcome = plan(scene.problem, Budget());
    const auto* found = std::get_if<Plan>(&outcome.answer);
    if (found == nullptr) {
      lost += best ? 1 : 0;
      continue;
    }
    ++plans;
    EXPECT_TRUE(found->verification.holds());
    EXPECT_TRUE(independent_check(scene.problem, found->trajectory).empty())
        << independent_check(scene.problem, found->trajectory).front();
    if (!best) continue;
    waits += best->first + best->second > 0.0 ? 1 : 0;
    slower += found->duration > best->duration + kMarginCosts ? 1 : 0;
    if (found->method == Method::kDelay || found->method == Method::kSimultaneous) {
      EXPECT_GE(found->duration, best->duration - 1e-9);
    }
  }
  EXPECT_GT(plans, 40);
  EXPECT_GT(waits, 15);
  EXPECT_LE(slower, 2);
  EXPECT_LE(lost, 2);
}

/// Arm 1 alone from 30 to 60 degrees, and a ball that goes straight down, from 9 m above its way at `begin` (s) on, to
/// the joint's height at `begin` + 5 s, and out of reach in 1 s more if it is to leave.
Problem falling_ball_problem(double begin, bool leaves) {
  Problem problem = paper_problem({30, 60}, {60, 30}, 0.05);
  problem.arms[1].base.position.x() = 100.0;
  const auto at_height = [](double height) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = Eigen::Vector3d(2.0, 2.0 * std::sqrt(3.0), height);
    return pose;
  };
  std::vector<TimedPose> poses = {{begin, at_height(9.0)}, {begin + 5.0, at_height(0.0)}};
  if (leaves) poses.push_back({begin + 6.0, at_height(-9.0)});
  problem.objects = {
      {"ball", Capsule{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 0.2}, MovingPlacement{PoseTrack(poses)}}};
  return problem;
}

TEST(PlanAmongMovingObjects, IsImpossibleWhereOneStaysAtAGoal) {
  for (const Method method : {Method::kDelay, Method::kStateTime}) {
    Problem problem = falling_ball_problem(3.0, false);
    problem.options.methods = {method};
    const Infeasible refusal = must_refuse(problem);
    EXPECT_EQ(refusal.reason, InfeasibleReason::kGoalInCollision);
    EXPECT_EQ(refusal.evidence.arm, problem.arms[0].name);
    EXPECT_EQ(refusal.evidence.second_body, "ball");
  }
}

TEST(PlanAmongMovingObjects, DoesNotEndBeforeTheLastHasPassedAGoal) {
  // The ball comes down long after the arms could have arrived: one rule for every method.
  for (const Method method : {Method::kSimultaneous, Method::kDelay, Method::kPassage, Method::kStateTime}) {
    Problem problem = falling_ball_problem(10.0, true);
    problem.options.methods = {Method::kDelay, method};
    if (method == Method::kStateTime) problem.options.methods = {method};
    const Plan found = must_plan(problem);
    const double passed = 15.0 + 0.25 / 9.0;  // s: 0.05 and 0.2 m below the arm's axis
    EXPECT_NEAR(found.certificate.lower_bound, passed, 1e-3);
    EXPECT_EQ(found.certificate.source, LowerBoundSource::kMovingObject);
    ASSERT_TRUE(found.certificate.visit);
    EXPECT_EQ(found.certificate.visit->object, "ball");
    EXPECT_GE(found.duration, found.certificate.lower_bound);
  }
}

TEST(PlanAmongMovingObjects, MayEndBeforeOnePassesAGoalThatAnArmLeaves) {
  Problem problem = falling_ball_problem(10.0, true);
  problem.tasks[0].goal.velocity = 0.2;
  const Plan found = must_plan(problem);
  EXPECT_LT(found.duration, 3.0);
  EXPECT_EQ(found.certificate.source, LowerBoundSource::kFastestMotions);
}

}  // namespace
}  // namespace dualarm
