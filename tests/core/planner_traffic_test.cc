// Plans among moving objects.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/coordination/diagram.h"
#include "core/coordination/moving_objects.h"
#include "core/coordination/start_times.h"
#include "core/passage/traffic_proof.h"
#include "core/planner.h"
#include "tests/core/coordination/random_traffic.h"
#include "tests/core/planner_answers.h"
#include "tests/support/dice.h"
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

/// A frame that is moved (m) and not turned.
Eigen::Isometry3d pose_at(double x, double y, double z = 0.0) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

/// Arm 1 alone from 30 to 60 degrees, and a ball that goes straight down, from 9 m above its way at `begin` (s) on, to
/// the joint's height at `begin` + 5 s, and out of reach in 1 s more if it is to leave.
Problem falling_ball_problem(double begin, bool leaves) {
  Problem problem = paper_problem({30, 60}, {60, 30}, 0.05);
  problem.arms[1].base.position.x() = 100.0;
  const auto at_height = [](double height) { return pose_at(2.0, 2.0 * std::sqrt(3.0), height); };
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

TEST(PlanAmongMovingObjects, IsImpossibleWhereOneIsInAnArmAsThePlanBegins) {
  Problem problem = falling_ball_problem(0.0, false);
  const double start = problem.tasks[0].start.position;
  const auto beyond = [&](double way) { return pose_at(way * std::cos(start), way * std::sin(start)); };
  problem.objects[0].placement = MovingPlacement{PoseTrack({{0.0, beyond(3.0)}, {0.5, beyond(9.0)}})};
  for (const Method method : {Method::kDelay, Method::kStateTime}) {
    problem.options.methods = {method};
    const Infeasible refusal = must_refuse(problem);
    EXPECT_EQ(refusal.reason, InfeasibleReason::kStartInCollision);
    EXPECT_EQ(refusal.evidence.first_body, problem.arms[0].name);
    EXPECT_EQ(refusal.evidence.second_body, "ball");
  }
  // What was there before and is gone counts for nothing.
  problem.objects[0].placement = MovingPlacement{PoseTrack({{-0.5, beyond(3.0)}, {0.0, beyond(9.0)}})};
  EXPECT_GT(must_plan(problem).duration, 0.0);
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

/// Arm 1 of the problem above, with a ball at 45 degrees, 5 m out, that lets it pass from about `end` (s) on.
Problem waiting_ball_problem(double end) {
  Problem problem = falling_ball_problem(0.0, false);
  const auto at_height = [](double height) { return pose_at(2.5 * std::sqrt(2.0), 2.5 * std::sqrt(2.0), height); };
  problem.objects[0].placement = MovingPlacement{PoseTrack({{end, at_height(0.0)}, {end + 0.01, at_height(9.0)}})};
  return problem;
}

/// The time (s) that arm 1 of the paper takes to brake from a position (rad) on the way to rest at a goal, by backward
/// integration, at no more than its velocity limit.
double braking_time(const Arm& arm, double from, double goal) {
  const double step = 1e-5;
  double position = goal;
  double velocity = 0.0;
  double time = 0.0;
  for (; position > from; time += step) {
    const double gravity = arm.gravity.amplitude * std::sin(position - arm.gravity.phase);
    const double braking = (gravity - std::get<Interval>(arm.torque).lower) / arm.inertia;
    velocity = std::min(arm.velocity.upper, velocity + step * braking);
    position -= step * velocity;
  }
  return time;
}

TEST(PlanAmongMovingObjects, IsBoundByWhatStandsInTheWayUntilLate) {
  for (const double end : {2.0, 7.0, 40.0}) {
    SCOPED_TRACE(end);
    const Problem problem = waiting_ball_problem(end);
    const Plan found = must_plan(problem);
    // Seen from the arm's axis the ball with the link's radius and the margin covers asin(0.25 / 5) to either side. It
    // is gone when it has risen by 0.25 m.
    const double edge = 0.25 * std::numbers::pi - std::asin(0.25 / 5.0);
    const double in_the_middle =
        end + 0.01 * 0.25 / 9.0 + braking_time(problem.arms[0], 0.25 * std::numbers::pi, 1.0472);
    EXPECT_GT(found.certificate.lower_bound, in_the_middle - 1e-3);
    EXPECT_LT(found.certificate.lower_bound, end + 0.01 + braking_time(problem.arms[0], edge, 1.0472));
    EXPECT_EQ(found.certificate.source, LowerBoundSource::kMovingObject);
    EXPECT_LT(found.certificate.gap, 0.2);
  }
}

TEST(PlanAmongMovingObjects, IsNeverFasterThanItsBound) {
  constexpr int kSeed = 11;
  SCOPED_TRACE(kSeed);
  Dice dice(kSeed);
  int bound_by_objects = 0;
  for (int scene = 0; scene < 10; ++scene) {
    SCOPED_TRACE(scene);
    Problem problem = falling_ball_problem(0.0, false);
    std::vector<TimedPose> poses;
    for (int i = 0; i < 3; ++i) {
      poses.push_back({dice.between(1.0, 2.0) * (i + 0.1), pose_at(dice.between(0.0, 6.0), dice.between(2.0, 6.0))});
    }
    poses.push_back({8.0, pose_at(9.0, 9.0)});
    problem.objects[0].shape = Box{Eigen::Isometry3d::Identity(), {0.3, 0.2, 0.1}};
    problem.objects[0].placement = MovingPlacement{PoseTrack(poses)};
    const auto proof = traffic_proof(problem, 0.0, 0.0, 1e4, Budget());  // looks beyond every plan that is known
    bound_by_objects += proof ? 1 : 0;
    for (const Method method : {Method::kDelay, Method::kStateTime}) {
      problem.options.methods = {method};
      const Outcome outcome = plan(problem, Budget());
      const auto* found = std::get_if<Plan>(&outcome.answer);
      if (found == nullptr) continue;
      EXPECT_GE(found->duration, found->certificate.lower_bound * (1.0 - 1e-9));
      EXPECT_GE(found->duration, proof ? proof->duration : 0.0);
    }
  }
  EXPECT_GT(bound_by_objects, 4);
}

TEST(PlanAmongMovingObjects, IsImpossibleWhereOneStaysInTheWay) {
  Problem problem = waiting_ball_problem(1.0);
  const PoseTrack& track = *tracked_bodies(problem)[0].track;
  problem.objects[0].placement = MovingPlacement{PoseTrack({track.poses().front()})};
  const Infeasible refusal = must_refuse(problem);
  EXPECT_EQ(refusal.reason, InfeasibleReason::kObjectInSweep);
  EXPECT_EQ(refusal.evidence.second_body, "ball");
}

TEST(PlanAmongMovingObjects, IsNotBoundByOneThatComesBehindAnArmInMotionAtItsGoal) {
  // The ball waits far beyond the goal and sweeps back over all of the way long after the plan: an arm that stayed at
  // its goal would have to let it pass first.
  Problem problem = falling_ball_problem(0.0, false);
  problem.tasks[0].goal.velocity = 0.05;
  std::vector<TimedPose> poses;
  for (int i = 0; i <= 12; ++i) {
    const double angle = (2.6 - 0.2 * i);
    poses.push_back({50.0 + i, pose_at(5.0 * std::cos(angle), 5.0 * std::sin(angle))});
  }
  problem.objects[0].placement = MovingPlacement{PoseTrack(poses)};
  const Plan found = must_plan(problem);
  EXPECT_LT(found.duration, 3.0);
  EXPECT_LE(found.certificate.lower_bound, found.duration);
  EXPECT_EQ(found.certificate.source, LowerBoundSource::kFastestMotions);
}

TEST(PlanAmongMovingObjects, EndsWithTheBudgetAlsoAmongThousandsOfPoses) {
  // A ball that jitters at the edge of what arm 1 reaches: every look at its track is long. The budget is over from the
  // start, so that any loop that does not look at it would take minutes.
  Problem problem = falling_ball_problem(0.0, false);
  std::vector<TimedPose> poses;
  for (int i = 0; i < 10000; ++i) {
    poses.push_back({1e-3 * (i + 1), pose_at(4.4 + 0.1 * (i % 2), 4.4 - 0.1 * (i % 3))});
  }
  problem.objects[0].placement = MovingPlacement{PoseTrack(poses)};
  const Outcome outcome = plan(problem, Budget(Budget::Clock::now()));
  EXPECT_FALSE(std::holds_alternative<Infeasible>(outcome.answer));
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
