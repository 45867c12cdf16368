#include "core/planner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/core/planner_answers.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;

struct WorkedRow {
  std::array<double, 2> start;
  std::array<double, 2> goal;
  double first;
  double second;
  double delay;  ///< s, of the best delay plan; 0 if none exists
  double bound;  ///< s, of the passage
  Method method;
};

class WorkedValues : public testing::TestWithParam<WorkedRow> {};

TEST_P(WorkedValues, AreReachedAndProvenToBeOptimal) {
  const WorkedRow& row = GetParam();
  for (const double radius : {0.0, 1e-3}) {
    const Plan found = must_plan(paper_problem(row.start, row.goal, radius));
    EXPECT_EQ(found.method, row.method);
    EXPECT_NEAR(found.duration, row.bound, 1e-3 * row.bound);
    EXPECT_NEAR(found.certificate.lower_bound, row.bound, radius == 0.0 ? 1e-5 : 1e-3);
    EXPECT_GE(found.duration, found.certificate.lower_bound);
    EXPECT_LT(found.certificate.gap, 2.5e-5);  // what the planning margin costs
    EXPECT_EQ(found.certificate.claim, Claim::kOptimal);
    EXPECT_EQ(found.certificate.source, LowerBoundSource::kPassage);
    ASSERT_TRUE(found.certificate.gate);
    EXPECT_NEAR(found.certificate.gate->pinned_position, std::acos(2.0 / 3.0), 1e-3);  // the tip of the lens
  }
}

TEST_P(WorkedValues, OfDelaysAreReachedWherePassagesAreNotAllowed) {
  const WorkedRow& row = GetParam();
  Problem problem = paper_problem(row.start, row.goal);
  problem.options.methods = {Method::kSimultaneous, Method::kDelay};
  if (row.delay == 0.0) {
    EXPECT_EQ(must_refuse(problem).reason, InfeasibleReason::kNoCoordination);
    return;
  }
  const Plan found = must_plan(problem);
  EXPECT_EQ(found.method, Method::kDelay);
  EXPECT_NEAR(found.trajectory[0].duration, row.first, 1e-4);
  EXPECT_NEAR(found.trajectory[1].duration, row.second, 1e-4);
  EXPECT_NEAR(found.duration, row.delay, 1e-4);
  EXPECT_EQ(found.certificate.claim == Claim::kOptimal, row.method == Method::kDelay);
  EXPECT_NEAR(found.certificate.gap, row.delay / row.bound - 1.0, 1e-4);
}

// theory.md, section 4.
INSTANTIATE_TEST_SUITE_P(
    Theory, WorkedValues,
    testing::Values(WorkedRow{{30, 60}, {60, 30}, 1.188197, 1.188197, 1.500925, 1.500925, Method::kDelay},
                    WorkedRow{{20, 90}, {90, 20}, 1.767860, 1.767860, 1.793744, 1.793744, Method::kDelay},
                    WorkedRow{{20, 70}, {60, 20}, 1.333816, 1.489711, 1.795627, 1.793744, Method::kPassage},
                    WorkedRow{{10, 80}, {60, 15}, 1.451674, 1.675828, 1.970339, 1.960533, Method::kPassage},
                    WorkedRow{{5, 60}, {50, 10}, 1.365145, 1.451674, 2.208863, 2.087963, Method::kPassage},
                    WorkedRow{{10, 40}, {40, 10}, 1.134967, 1.134967, 0.0, 2.144247, Method::kPassage}));

TEST(Planner, RetreatsWhereTheExtremalMotionsClipTheSet) {
  Problem problem = paper_problem({10, 40}, {40, 10}, 0.2);
  for (Arm& arm : problem.arms) arm.inertia = 12.0;
  problem.options.methods = {Method::kSimultaneous, Method::kDelay, Method::kPassage};
  const Plan found = must_plan(problem);
  EXPECT_EQ(found.method, Method::kPassage);
  EXPECT_LT(found.duration, 1.270);  // a transcription finds 1.2654
  EXPECT_NEAR(found.certificate.lower_bound, 1.2405, 1e-4);
  EXPECT_EQ(found.certificate.claim, Claim::kGap);
}

TEST(Planner, OvershootsWhereMovingStartsCannotWait) {
  Problem problem = paper_problem({30, 60}, {60, 30}, 0.05);
  problem.tasks[0].start.velocity = 0.2;
  problem.tasks[1].start.velocity = -0.2;
  problem.options.methods = {Method::kSimultaneous, Method::kDelay, Method::kPassage};
  const Plan found = must_plan(problem);
  EXPECT_EQ(found.method, Method::kPassage);
  EXPECT_EQ(found.trajectory[0].start_time, 0.0);
  EXPECT_EQ(found.trajectory[1].start_time, 0.0);
  EXPECT_EQ(found.certificate.source, LowerBoundSource::kPassage);
}

TEST(Planner, RefusesWhatTheForbiddenSetParts) {
  Problem problem = paper_problem({10, 40}, {40, 10}, 0.1);
  for (Arm& arm : problem.arms) arm.joint_range = {0.0, 0.25 * kPi};
  const Infeasible refused = must_refuse(problem);
  EXPECT_EQ(refused.reason, InfeasibleReason::kNoCoordination);
  EXPECT_THAT(refused.explanation, testing::HasSubstr("no path leads from the start to the goal"));
}

TEST(Planner, MovesBothArmsTogetherWhereThatIsFree) {
  const Plan found = must_plan(paper_problem({100, 90}, {140, 150}, 0.1));
  EXPECT_EQ(found.method, Method::kSimultaneous);
  EXPECT_EQ(found.certificate.claim, Claim::kOptimal);
  EXPECT_EQ(found.certificate.gap, 0.0);
  EXPECT_EQ(found.trajectory[0].start_time, 0.0);
  EXPECT_EQ(found.trajectory[1].start_time, 0.0);
}

TEST(Planner, SolvesTheRetreatBySearchWhereNoDelayExistsAndNoPassageIsAllowed) {
  Problem problem = paper_problem({10, 40}, {40, 10}, 0.05);
  problem.options.methods = {Method::kSimultaneous, Method::kDelay, Method::kStateTime};
  const Plan found = must_plan(problem);
  EXPECT_EQ(found.method, Method::kStateTime);
  EXPECT_GT(found.duration, 2.1442);  // the proven bound without radius; theory.md, section 4
  EXPECT_GT(found.certificate.lower_bound, 2.1442);
  EXPECT_GE(found.duration, found.certificate.lower_bound);
}

TEST(Planner, RefusesTheRetreatWhereOnlyDelaysAreAllowed) {
  Problem problem = paper_problem({10, 40}, {40, 10}, 0.05);
  problem.options.methods = {Method::kSimultaneous, Method::kDelay};
  EXPECT_EQ(must_refuse(problem).reason, InfeasibleReason::kNoCoordination);
}

TEST(Planner, ForcedToSearchFindsAPlanWhereADelayWouldDo) {
  Problem problem = paper_problem({30, 60}, {60, 30}, 0.05);
  problem.options.methods = {Method::kStateTime};
  EXPECT_EQ(must_plan(problem).method, Method::kStateTime);
}

TEST(Planner, KeepsTheLargestStartDelay) {
  Problem problem = paper_problem({30, 60}, {60, 30}, 0.05);
  problem.options.methods = {Method::kSimultaneous, Method::kDelay};
  const Plan found = must_plan(problem);
  const double delay = std::max(found.trajectory[0].start_time, found.trajectory[1].start_time);
  problem.options.max_start_delay = delay + 1e-6;
  must_plan(problem);
  problem.options.max_start_delay = delay - 1e-3;
  const Infeasible refused = must_refuse(problem);
  EXPECT_EQ(refused.reason, InfeasibleReason::kNoCoordination);
  ASSERT_TRUE(refused.evidence.relaxation);
  EXPECT_NEAR(*refused.evidence.relaxation, 1e-3, 1e-9);
}

TEST(Planner, KeepsTheLargestStartDelayInTheSearchToo) {
  Problem problem = paper_problem({30, 60}, {60, 30}, 0.05);
  problem.options.max_start_delay = 0.01;
  const Outcome outcome = plan(problem, Budget());
  if (const auto* found = std::get_if<Plan>(&outcome.answer)) {
    for (const ArmTrajectory& arm : found->trajectory) EXPECT_LE(arm.start_time, 0.01);
  } else {
    EXPECT_TRUE(std::holds_alternative<Undecided>(outcome.answer));
  }
}

TEST(Planner, PlansFromStartsThatHardlyKeepTheClearance) {
  Problem problem = paper_problem({30, 60}, {60, 30}, 0.05);
  const double distance = -*must_refuse(paper_problem({30, 60}, {60, 30}, 0.05, 10.0)).evidence.depth + 10.0;
  for (const double slack : {3e-5, 1.5e-4}) {
    problem.options.clearance = distance - slack;
    EXPECT_GE(must_plan(problem).verification.min_clearance, problem.options.clearance) << slack;
  }
}

TEST(Planner, PlaysTinyMovesAndDenseKnotsWithinTheTorqueLimits) {
  for (const double move : {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
    for (const double from : {30.0, 120.0}) {
      Problem problem = paper_problem({from, 150}, {from, 150}, 0.05);
      problem.tasks[0].goal.position += move;
      must_plan(problem);
    }
  }
  Problem dense = paper_problem({20, 70}, {60, 20}, 0.05);
  dense.options.knot_period = 1e-3;
  must_plan(dense);
  // A tower crane: much inertia, many knots.
  for (Arm& arm : dense.arms) {
    arm.inertia = 1.6e7;
    arm.gravity.amplitude = 0.0;
    arm.torque = Interval{-1.2e5, 1.2e5};
    arm.velocity = {-0.0733, 0.0733};
  }
  must_plan(dense);
}

TEST(Planner, CoversEveryPairOfDirectionsAndTheirMirrorImages) {
  // Cases 1, 2 and 3 of the paper as theory.md, section 3 reads them, arms that stay, and all with the arms exchanged.
  const std::array<std::array<double, 2>, 2> moves[] = {
      {{{20, 70}, {60, 20}}},  {{{10, 50}, {70, 90}}},   {{{60, 90}, {20, 60}}}, {{{60, 20}, {20, 70}}},
      {{{20, 120}, {20, 80}}}, {{{20, 120}, {60, 120}}}, {{{70, 80}, {70, 80}}}};
  for (const auto& [start, goal] : moves) {
    const Plan found = must_plan(paper_problem(start, goal, 0.1));
    const Plan exchanged = must_plan(paper_problem({start[1], start[0]}, {goal[1], goal[0]}, 0.1));
    EXPECT_NEAR(found.duration, exchanged.duration, 1e-9) << start[0] << " " << start[1];
    Problem turned = paper_problem(start, goal, 0.1);
    for (Arm& arm : turned.arms) {
      arm.base.heading = -arm.base.heading;
      arm.base.rotation =
          arm.base.rotation == Rotation::kClockwise ? Rotation::kCounterclockwise : Rotation::kClockwise;
    }
    EXPECT_NEAR(must_plan(turned).duration, found.duration, 1e-9) << start[0] << " " << start[1];
  }
}

TEST(Planner, WaitsLongerForThePapersSetThanForTheExactOne) {
  Problem problem = paper_problem({20, 90}, {90, 20}, 0.05);
  problem.arms[0].velocity = {-0.5, 0.5};
  const double exact = must_plan(problem).trajectory[1].start_time;
  problem.options.region_model = RegionModel::kPaper;
  EXPECT_GT(must_plan(problem).trajectory[1].start_time, exact + 1e-3);
}

TEST(Planner, RefusesAGoalInThePapersSetThatIsFreeInTruth) {
  Problem problem = paper_problem({20, 70}, {60, 20}, 0.05);
  must_plan(problem);
  problem.options.region_model = RegionModel::kPaper;
  EXPECT_EQ(must_refuse(problem).reason, InfeasibleReason::kGoalInCollision);
}

TEST(Planner, KeepsTheDemandedClearanceAndWaitsLongerForMore) {
  double previous = 0.0;
  for (const double clearance : {0.0, 0.1, 0.5}) {
    const Plan found = must_plan(paper_problem({30, 60}, {60, 30}, 0.1, clearance));
    EXPECT_GE(found.verification.min_clearance, clearance);
    EXPECT_LT(found.verification.min_clearance, clearance + 1e-3);  // an optimal plan touches
    EXPECT_GT(found.duration, previous);
    previous = found.duration;
  }
}

TEST(Planner, TakesACarriedObjectIntoAccountInDynamicsAndGeometry) {
  Problem problem = paper_problem({20, 70}, {60, 20}, 0.05);
  const Plan empty = must_plan(problem);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(6.3, 0.0, 0.0);
  problem.objects = {{"beam", Capsule{{0, -1.0, 0}, {0, 1.0, 0}, 0.1}, AttachedPlacement{0, pose, 0.4}}};
  for (Arm& arm : problem.arms) arm.payload_gravity = 9.81;
  const Plan loaded = must_plan(problem);
  EXPECT_GT(loaded.trajectory[0].duration, empty.trajectory[0].duration);
  EXPECT_GT(loaded.duration, empty.duration);
}

TEST(Planner, RefusesWhatStandsInTheWay) {
  Problem problem = paper_problem({20, 100}, {80, 140}, 0.1);
  problem.objects = {ball("post", {6.0 * std::cos(0.9), 6.0 * std::sin(0.9), 0.0}, 0.2)};
  const Infeasible refused = must_refuse(problem);
  EXPECT_EQ(refused.reason, InfeasibleReason::kObjectInSweep);
  EXPECT_EQ(refused.evidence.arm, "arm1");
  EXPECT_EQ(refused.evidence.second_body, "post");
}

TEST(Planner, LeavesAnObjectAloneThatNoArmReaches) {
  Problem problem = paper_problem({20, 100}, {80, 140}, 0.1);
  problem.objects = {ball("post", {0.0, 9.0, 0.0}, 0.2), ball("lamp", {3.0, 3.0, 4.0}, 0.2)};
  must_plan(problem);
}

TEST(Planner, RefusesStartsAndGoalsInCollision) {
  const Infeasible start = must_refuse(paper_problem({20, 21}, {100, 100}, 0.1));
  EXPECT_EQ(start.reason, InfeasibleReason::kStartInCollision);
  EXPECT_EQ(start.evidence.first_body, "arm1");
  EXPECT_EQ(start.evidence.second_body, "arm2");
  ASSERT_TRUE(start.evidence.depth);
  EXPECT_GT(*start.evidence.depth, 0.0);
  EXPECT_EQ(must_refuse(paper_problem({100, 100}, {20, 21}, 0.1)).reason, InfeasibleReason::kGoalInCollision);
}

TEST(Planner, RefusesStatesOutsideTheRange) {
  EXPECT_EQ(must_refuse(paper_problem({-5, 100}, {80, 140})).reason, InfeasibleReason::kStartOutsideRange);
  const Infeasible goal = must_refuse(paper_problem({20, 100}, {80, 190}));
  EXPECT_EQ(goal.reason, InfeasibleReason::kGoalOutsideRange);
  EXPECT_EQ(goal.evidence.arm, "arm2");
  EXPECT_NEAR(*goal.evidence.relaxation, kPi / 18.0, 1e-12);
}

TEST(Planner, RefusesWhatTheDriveCannotHoldOrPass) {
  Problem problem = paper_problem({45, 100}, {80, 140});
  problem.arms[0].torque = Interval{-20.0, 20.0};
  const Infeasible start = must_refuse(problem);
  EXPECT_EQ(start.reason, InfeasibleReason::kStartNotHoldable);
  EXPECT_NEAR(*start.evidence.needed_torque, 29.43 * std::sin(0.25 * kPi), 1e-9);
  EXPECT_EQ(*start.evidence.available_torque, 20.0);
  problem.tasks[0] = {{0.1, 0.0}, {3.0, 0.0}};
  const Infeasible way = must_refuse(problem);
  EXPECT_EQ(way.reason, InfeasibleReason::kTorqueTooSmall);
  EXPECT_GT(*way.evidence.needed_torque, *way.evidence.available_torque);
  problem.tasks[0] = {{0.1, 0.0}, {1.2, 0.0}};
  EXPECT_EQ(must_refuse(problem).reason, InfeasibleReason::kGoalNotHoldable);
}

TEST(Planner, ReturnsTheSamePlanForTheSameProblem) {
  for (const Problem& problem : {paper_problem({30, 60}, {60, 30}, 0.1), paper_problem({10, 40}, {40, 10}, 0.05)}) {
    const Plan first = must_plan(problem);
    const Plan second = must_plan(problem);
    ASSERT_EQ(first.trajectory[0].knots.size(), second.trajectory[0].knots.size());
    for (std::size_t i = 0; i < first.trajectory[0].knots.size(); ++i) {
      EXPECT_EQ(first.trajectory[0].knots[i].position, second.trajectory[0].knots[i].position);
    }
    EXPECT_EQ(first.duration, second.duration);
  }
}

TEST(Planner, AsksForALongerKnotPeriodWhereThePlanWouldHaveTooManyKnots) {
  Problem problem = paper_problem({100, 90}, {140, 150}, 0.1);
  problem.options.knot_period = 1e-5;
  const Outcome outcome = plan(problem, Budget());
  const auto* undecided = std::get_if<Undecided>(&outcome.answer);
  ASSERT_NE(undecided, nullptr);
  EXPECT_THAT(undecided->explanation, testing::HasSubstr("ask for a longer knot period"));
}

TEST(Planner, IsUndecidedWhenItsBudgetIsGone) {
  const Budget gone(Budget::Clock::now() - std::chrono::seconds(1));
  const Outcome outcome = plan(paper_problem({10, 40}, {40, 10}, 0.05), gone);
  const auto* undecided = std::get_if<Undecided>(&outcome.answer);
  ASSERT_NE(undecided, nullptr);
  EXPECT_FALSE(undecided->tried.empty());
  EXPECT_GT(undecided->best_lower_bound, 1.0);
}

}  // namespace
}  // namespace dualarm
