// Plans among moving objects.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/coordination/diagram.h"
#include "core/coordination/moving_objects.h"
#include "core/coordination/start_times.h"
#include "core/planner.h"
#include "tests/core/coordination/random_traffic.h"
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

TEST(PlanAmongMovingObjects, IsNotCalledImpossibleForTheirSake) {
  // A ball parks in the goal of arm 1; other methods than delays are not allowed.
  Problem problem = paper_problem({30, 60}, {60, 30}, 0.05);
  problem.arms[1].base.position.x() = 100.0;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(2.0, 2.0 * std::sqrt(3.0), 9.0);
  std::vector<TimedPose> poses = {{0.0, pose}};
  pose.translation().z() = 0.0;
  poses.push_back({5.0, pose});
  problem.objects = {
      {"ball", Capsule{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 0.2}, MovingPlacement{PoseTrack(poses)}}};
  problem.options.methods = {Method::kSimultaneous, Method::kDelay};
  const Outcome outcome = plan(problem, Budget());
  ASSERT_TRUE(std::holds_alternative<Undecided>(outcome.answer) || std::holds_alternative<Infeasible>(outcome.answer));
  if (const auto* refusal = std::get_if<Infeasible>(&outcome.answer)) {
    EXPECT_EQ(refusal->reason, InfeasibleReason::kGoalInCollision);
  }
}

}  // namespace
}  // namespace dualarm
