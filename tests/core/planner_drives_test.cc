#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/planner.h"
#include "tests/core/planner_answers.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;

/// Arm 1 of the paper alone, the other out of reach, upright its goal, without a velocity limit that matters, its
/// torque a share of gravity's amplitude.
Problem weak_problem(double start_degrees, double share) {
  Problem problem = paper_problem({start_degrees, 100}, {180, 100}, 0.05);
  problem.arms[1].base.position.x() = 20.0;
  Arm& arm = problem.arms[0];
  arm.torque = Interval{-share * arm.gravity.amplitude, share * arm.gravity.amplitude};
  arm.velocity = {-20.0, 20.0};
  arm.joint_range = {-4.0, 4.0};
  return problem;
}

TEST(PlannerOfAnyDrive, SwingsAWeakArmUp) {
  // theory.md, section 1.3: start, torque over gravity's amplitude, duration in units of sqrt(I / G).
  const double rows[][3] = {{0, 0.60, 6.696}, {0, 0.76, 5.790}, {90, 1.01, 5.872}, {90, 1.05, 5.785}};
  for (const auto& [start, share, duration] : rows) {
    SCOPED_TRACE(share);
    const Problem problem = weak_problem(start, share);
    const Plan found = must_plan(problem);
    const double unit = std::sqrt(problem.arms[0].inertia / problem.arms[0].gravity.amplitude);
    EXPECT_NEAR(found.duration / unit, duration, 5e-4);
    EXPECT_EQ(found.method, Method::kSimultaneous);
    EXPECT_EQ(found.certificate.claim, Claim::kGap);
    EXPECT_GT(found.certificate.lower_bound, 0.0);
    EXPECT_LT(found.certificate.lower_bound, found.duration);
  }
}

TEST(PlannerOfAnyDrive, CallsImpossibleWhatNoSwingCanDo) {
  Problem problem = weak_problem(0, 0.60);
  problem.arms[0].joint_range = {0.0, kPi};
  EXPECT_EQ(must_refuse(problem).reason, InfeasibleReason::kTorqueTooSmall);
}

TEST(PlannerOfAnyDrive, SaysThatTimeRanOutBeforeASwingWasFound) {
  const Outcome outcome = plan(weak_problem(0, 0.60), Budget(Budget::Clock::now()));
  const auto* undecided = std::get_if<Undecided>(&outcome.answer);
  ASSERT_NE(undecided, nullptr);
  EXPECT_THAT(undecided->tried.front(), testing::HasSubstr("Time ran out in the search for motions that swing"));
}

TEST(PlannerOfAnyDrive, CallsImpossibleWhatOnlyAVelocityLimitForbids) {
  Problem problem = weak_problem(0, 0.76);
  must_plan(problem);
  problem.arms[0].velocity = {-0.1, 0.1};
  const Infeasible refused = must_refuse(problem);
  EXPECT_EQ(refused.reason, InfeasibleReason::kVelocityLimit);
  ASSERT_TRUE(refused.evidence.relaxation);
  problem.arms[0].velocity.lower -= 1.001 * *refused.evidence.relaxation;
  problem.arms[0].velocity.upper += 1.001 * *refused.evidence.relaxation;
  must_plan(problem);
}

TEST(PlannerOfAnyDrive, SwingsOnlyWhereFixedObjectsLeaveRoom) {
  Problem problem = weak_problem(0, 0.60);
  const double free_duration = must_plan(problem).duration;
  // In the way of nothing that the swing needs, then in the way of a part of it, then of all of it.
  problem.objects = {ball("post", {6.0 * std::cos(3.4), 6.0 * std::sin(3.4), 0.0}, 0.2)};
  EXPECT_NEAR(must_plan(problem).duration, free_duration, 1e-9);
  problem.objects = {ball("post", {6.0 * std::cos(-0.8), 6.0 * std::sin(-0.8), 0.0}, 0.2)};
  const Plan squeezed = must_plan(problem);
  EXPECT_GT(squeezed.duration, free_duration);
  problem.objects = {ball("post", {6.0 * std::cos(-0.1), 6.0 * std::sin(-0.1), 0.0}, 0.2)};
  EXPECT_EQ(must_refuse(problem).reason, InfeasibleReason::kTorqueTooSmall);
}

TEST(PlannerOfAnyDrive, LetsTheOtherArmWaitForASwing) {
  // Arm 1 swings up past arm 2, which has to come down to where the swing passes.
  Problem problem = weak_problem(0, 0.60);
  problem.arms[1].base.position.x() = 8.0;
  problem.tasks[1] = {{kPi / 2, 0.0}, {kPi / 6, 0.0}};
  const Plan found = must_plan(problem);
  EXPECT_NE(found.method, Method::kStateTime);
}

/// Limits that depend on velocity or position, friction; each makes the arms slower than the paper's.
TEST(PlannerOfAnyDrive, KeepsTorqueSpeedLinesTablesAndFriction) {
  const Problem plain = paper_problem({20, 70}, {60, 20}, 0.05);
  const double shortest = must_plan(plain).duration;
  Problem lines = plain;
  for (Arm& arm : lines.arms) arm.torque = TorqueSpeedLine{60.0, 2.5};
  EXPECT_GT(must_plan(lines).duration, shortest);
  Problem friction = plain;
  for (Arm& arm : friction.arms) {
    arm.viscous_friction = 5.0;
    arm.torque = Interval{-50.0, 60.0};
  }
  must_plan(friction);
  Problem tables = plain;
  for (Arm& arm : tables.arms) {
    arm.torque =
        TorqueTable{{0.3, 1.2}, {-2.0, 0.0, 2.0}, {{-60, 45}, {-60, 60}, {-50, 40}, {-45, 50}, {-60, 55}, {-50, 40}}};
  }
  EXPECT_GT(must_plan(tables).duration, shortest);
}

TEST(PlannerOfAnyDrive, BeginsAtOnceWithAnArmInMotion) {
  Problem problem = paper_problem({30, 60}, {60, 30}, 0.05);
  const Plan at_rest = must_plan(problem);
  problem.tasks[0].start.velocity = 0.3;
  const Plan found = must_plan(problem);
  EXPECT_EQ(found.trajectory[0].start_time, 0.0);
  EXPECT_EQ(found.trajectory[0].knots.front().velocity, 0.3);
  EXPECT_LT(found.duration, at_rest.duration);
}

TEST(PlannerOfAnyDrive, ArrivesAtTheEndWithAnArmInMotion) {
  Problem problem = paper_problem({100, 90}, {140, 150}, 0.1);
  problem.tasks[0].goal.velocity = 0.4;
  const Plan found = must_plan(problem);
  EXPECT_EQ(found.method, Method::kDelay);
  EXPECT_GT(found.trajectory[0].start_time, 0.0);
  EXPECT_EQ(found.trajectory[0].knots.back().velocity, 0.4);
  EXPECT_EQ(found.trajectory[0].knots.back().time, found.duration);
  EXPECT_EQ(found.certificate.claim, Claim::kOptimal);
}

TEST(PlannerOfAnyDrive, TurnsBackWhereTheStartPointsAway) {
  Problem problem = paper_problem({100, 90}, {140, 150}, 0.1);
  problem.tasks[0].start.velocity = -0.5;
  problem.tasks[1].start.velocity = 0.25;
  const Plan found = must_plan(problem);
  EXPECT_EQ(found.method, Method::kSimultaneous);
  // Nothing is in the way of any delay, but neither arm can wait.
  EXPECT_EQ(found.certificate.safe_start_delays.intervals(), (std::vector<Interval>{{0.0, 0.0}}));
  const auto& knots = found.trajectory[0].knots;
  EXPECT_TRUE(std::any_of(knots.begin(), knots.end(),
                          [&](const Knot& knot) { return knot.position < problem.tasks[0].start.position - 0.01; }));
}

TEST(PlannerOfAnyDrive, StretchesAMotionThatCanNeitherWaitNorBeEarly) {
  Problem problem = paper_problem({100, 90}, {140, 150}, 0.1);
  problem.tasks[0].start.velocity = 0.1;
  problem.tasks[0].goal.velocity = 0.1;
  const Plan found = must_plan(problem);
  EXPECT_EQ(found.method, Method::kStateTime);
  EXPECT_LT(found.certificate.gap, 1e-3);  // the other arm's fastest motion, which takes longer, is the bound
  problem.options.methods = {Method::kSimultaneous, Method::kDelay, Method::kPassage};
  const Outcome outcome = plan(problem, Budget());
  const auto* undecided = std::get_if<Undecided>(&outcome.answer);
  ASSERT_NE(undecided, nullptr);
  EXPECT_THAT(undecided->tried, testing::ElementsAre(testing::HasSubstr("would have to be stretched"),
                                                     testing::HasSubstr("no gate was found")));
  EXPECT_GT(undecided->best_lower_bound, 1.0);
}

TEST(PlannerOfAnyDrive, RefusesStartsAndGoalsThatAreTooFast) {
  Problem problem = paper_problem({170, 90}, {140, 150}, 0.1);
  problem.tasks[0].start.velocity = 1.9;
  const Infeasible start = must_refuse(problem);
  EXPECT_EQ(start.reason, InfeasibleReason::kStartTooFast);
  EXPECT_NEAR(start.evidence.position.value(), kPi, 1e-12);
  EXPECT_GT(start.evidence.velocity.value(), 0.0);
  problem.tasks[0] = {{1.0, 0.0}, {3.0, -1.9}};
  EXPECT_EQ(must_refuse(problem).reason, InfeasibleReason::kGoalTooFast);
  problem.tasks[0] = {{1.0, 2.1}, {3.0, 0.0}};
  EXPECT_EQ(must_refuse(problem).reason, InfeasibleReason::kStartTooFast);
}

TEST(PlannerOfAnyDrive, KeepsAnOvershootClearOfFixedObjects) {
  // Too fast to stop at its goal, arm 1 goes past it and comes back; a post leaves it room, then not enough.
  Problem problem = paper_problem({100, 90}, {104, 150}, 0.1);
  problem.tasks[0].start.velocity = 1.0;
  const Plan found = must_plan(problem);
  const auto highest = [](const Plan& planned) {
    double most = 0.0;
    for (const Knot& knot : planned.trajectory[0].knots) most = std::max(most, knot.position);
    return most;
  };
  const double turn = highest(found);
  ASSERT_GT(turn, problem.tasks[0].goal.position + 0.05);
  const auto post_at = [](double angle) {
    return ball("post", {6.0 * std::cos(angle), 6.0 * std::sin(angle), 0.0}, 0.2);
  };
  const double half = 2.0 * std::asin(0.5 * 0.3 / 6.0);
  problem.objects = {post_at(turn + half + 0.01)};
  must_plan(problem);
  problem.objects = {post_at(turn + half - 0.02)};
  const Infeasible refused = must_refuse(problem);
  EXPECT_EQ(refused.reason, InfeasibleReason::kStartTooFast);
  EXPECT_EQ(refused.evidence.second_body, "post");
}

}  // namespace
}  // namespace dualarm
