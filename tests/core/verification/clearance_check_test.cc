#include "core/verification/clearance_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/verification/tolerances.h"
#include "geometry/chain.h"
#include "geometry/clearance.h"
#include "tests/core/verification/sample_motions.h"
#include "tests/support/exact_distance.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

ClearanceReport clearance_of(const Problem& problem, const Trajectory& trajectory, const Budget& budget = Budget()) {
  const std::array<Interpolant, kArmCount> motions = {Interpolant(trajectory[0].knots),
                                                      Interpolant(trajectory[1].knots)};
  return check_clearance(problem, motions, trajectory[0].knots.back().time, budget);
}

double sampled_minimum(const Problem& problem, const Trajectory& trajectory, int instants) {
  const std::array<Interpolant, kArmCount> motions = {Interpolant(trajectory[0].knots),
                                                      Interpolant(trajectory[1].knots)};
  const double duration = trajectory[0].knots.back().time;
  double least = 1e300;
  for (int k = 0; k <= instants; ++k) {
    std::array<Capsule, kArmCount> links;
    for (int i = 0; i < kArmCount; ++i) {
      const double position = motions[i].state(duration * k / instants).position;
      links[i] =
          placed(std::get<Capsule>(moving_bodies(problem, i)[0].shape), link_pose(problem.arms[i].base, position));
    }
    least = std::min(least, static_cast<double>(exact_distance(links[0], links[1])));
  }
  return least;
}

/// A random problem without gravity whose arms move at full torque, whatever lies in the way.
Problem random_weightless_problem(std::uint64_t seed) {
  Problem problem = random_problem(seed);
  for (Arm& arm : problem.arms) arm.gravity = {};
  return problem;
}

TEST(ClearanceCheck, FindsTheSmallestDistanceOfRandomMotionsAndProvesItWithFewQueries) {
  int free = 0;
  int most_queries = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem = random_weightless_problem(seed);
    const Trajectory trajectory = parabolic_motion(problem, {0.0, 0.1 * static_cast<double>(seed % 5)});
    const ClearanceReport report = clearance_of(problem, trajectory);
    const double sampled = sampled_minimum(problem, trajectory, 2000);
    EXPECT_EQ(report.collision_free, report.violations.empty());
    if (report.collision_free) {
      ++free;
      most_queries = std::max(most_queries, report.distance_query_count);
      EXPECT_GE(report.min_clearance, problem.options.clearance);
      EXPECT_LE(report.min_clearance, sampled);
      const double told_to = kClearanceShare * (sampled - problem.options.clearance);
      EXPECT_NEAR(report.min_clearance, sampled, 1e-4 + told_to);
    } else {
      ASSERT_EQ(report.violations.size(), 1u);
      EXPECT_EQ(report.violations[0].kind, ViolationKind::kClearance);
      EXPECT_LT(report.violations[0].value, problem.options.clearance);
      EXPECT_GE(report.violations[0].value, sampled - 1e-3);
    }
  }
  EXPECT_GT(free, 50);
  EXPECT_LT(free, 290);
  EXPECT_LT(most_queries, 1000);
}

TEST(ClearanceCheck, ATouchAtThePlannedMarginIsProvenWithFewQueries) {
  Problem problem = weightless_problem({20.0, 70.0}, {60.0, 20.0}, 0.1, 0.0);
  const Trajectory trajectory = parabolic_motion(problem, {0.0, 0.2});
  const double least = clearance_of(problem, trajectory).min_clearance;
  problem.options.clearance = least - 1e-4;
  const ClearanceReport report = clearance_of(problem, trajectory);
  EXPECT_TRUE(report.collision_free);
  EXPECT_LT(report.distance_query_count, 150);
}

TEST(ClearanceCheck, ToldToAMicrometreWhereItIsScarceAndToAShareOfWhatIsToSpare) {
  Problem problem = weightless_problem({20.0, 70.0}, {60.0, 20.0}, 0.1, 0.0);
  const Trajectory trajectory = parabolic_motion(problem, {0.0, 0.2});
  problem.options.clearance = 0.0;
  const ClearanceReport roomy = clearance_of(problem, trajectory);
  const double least = sampled_minimum(problem, trajectory, 200000);
  ASSERT_GT(least, 0.01);
  const double of_fcl = clearance_error(moving_bodies(problem, 0)[0].shape, moving_bodies(problem, 1)[0].shape);
  EXPECT_GE(roomy.min_clearance, least - kClearanceShare * least - of_fcl);
  problem.options.clearance = least - 1e-3;
  const ClearanceReport scarce = clearance_of(problem, trajectory);
  EXPECT_GE(scarce.min_clearance, least - kClearanceResolution - of_fcl);
  EXPECT_LT(roomy.distance_query_count, scarce.distance_query_count);
}

TEST(ClearanceCheck, TellsAMicrometreTooCloseFromFarEnough) {
  Problem problem = weightless_problem({20.0, 70.0}, {60.0, 20.0}, 0.1, 0.0);
  const Trajectory trajectory = parabolic_motion(problem, {0.0, 0.2});
  const double least = sampled_minimum(problem, trajectory, 200000);
  problem.options.clearance = least - 1e-6;
  EXPECT_TRUE(clearance_of(problem, trajectory).collision_free);
  problem.options.clearance = least + 1e-6;
  const ClearanceReport report = clearance_of(problem, trajectory);
  EXPECT_FALSE(report.collision_free);
  ASSERT_EQ(report.violations.size(), 1u);
  EXPECT_EQ(report.violations[0].kind, ViolationKind::kClearance);
}

TEST(ClearanceCheck, EvidenceNamesBodiesTimeAndWitnessPoints) {
  const Problem problem = weightless_problem({20.0, 70.0}, {60.0, 20.0}, 0.1, 0.0);
  const ClearanceReport report = clearance_of(problem, parabolic_motion(problem, {0.2, 0.0}));
  EXPECT_FALSE(report.collision_free);
  ASSERT_TRUE(report.closest.has_value());
  EXPECT_EQ(report.closest->first_body, "arm1");
  EXPECT_EQ(report.closest->second_body, "arm2");
  ASSERT_EQ(report.violations.size(), 1u);
  EXPECT_EQ(report.violations[0].time, report.closest->time);
  EXPECT_EQ(report.min_clearance, report.violations[0].value);
}

TEST(ClearanceCheck, ArmsAtRestNeedOneQuery) {
  const Problem problem = paper_problem({60.0, 120.0}, {60.0, 120.0}, 0.1, 0.05);
  for (const double duration : {0.0, 5.0}) {
    const ClearanceReport report = clearance_of(problem, resting_motion(problem, duration));
    EXPECT_TRUE(report.collision_free);
    EXPECT_EQ(report.distance_query_count, 1);
  }
}

TEST(ClearanceCheck, ArmsThatRestTooCloseAreAViolation) {
  const Problem problem = paper_problem({40.0, 30.0}, {40.0, 30.0}, 0.1, 0.0);
  for (const double duration : {0.0, 5.0}) {
    const ClearanceReport report = clearance_of(problem, resting_motion(problem, duration));
    EXPECT_FALSE(report.collision_free);
    ASSERT_EQ(report.violations.size(), 1u);
    EXPECT_EQ(report.violations[0].kind, ViolationKind::kClearance);
  }
}

TEST(ClearanceCheck, BareSegmentsThatCrossCollideThoughNoClearanceIsDemanded) {
  const Problem problem = weightless_problem({20.0, 70.0}, {60.0, 20.0}, 0.0, 0.0);
  const ClearanceReport report = clearance_of(problem, parabolic_motion(problem, {0.2, 0.0}));
  EXPECT_FALSE(report.collision_free);
  ASSERT_EQ(report.violations.size(), 1u);
  EXPECT_EQ(report.violations[0].kind, ViolationKind::kClearance);
  EXPECT_LT(report.distance_query_count, 1000);
}

TEST(ClearanceCheck, EveryPairOfCarriedAndFixedBodiesIsHeld) {
  Problem problem = paper_problem({90.0, 90.0}, {90.0, 90.0}, 0.1, 0.0);
  const Capsule ball = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.5};
  const auto carried = [&](int arm, double along) {
    return Object{"carried by " + problem.arms[arm].name, ball,
                  AttachedPlacement{arm, Eigen::Isometry3d(Eigen::Translation3d(along, 0.0, 0.0)), 0.0}};
  };
  const auto fixed = [&](double x, double y) {
    return Object{"fixed", ball, FixedPlacement{Eigen::Isometry3d(Eigen::Translation3d(x, y, 0.0))}};
  };
  const auto closest = [&](std::vector<Object> objects) {
    problem.objects = std::move(objects);
    return clearance_of(problem, resting_motion(problem, 1.0)).min_clearance;
  };
  EXPECT_NEAR(closest({}), 7.8, 1e-5);
  EXPECT_NEAR(closest({carried(0, 3.0)}), 7.4, 1e-5);
  EXPECT_NEAR(closest({carried(0, 3.0), carried(1, 3.0)}), 7.0, 1e-5);
  EXPECT_NEAR(closest({fixed(4.0, 3.0)}), 3.4, 1e-5);
  EXPECT_NEAR(closest({fixed(6.0, 3.0)}), 1.4, 1e-5);
  EXPECT_NEAR(closest({carried(0, 3.0), fixed(2.0, 3.0)}), 1.0, 1e-5);
  EXPECT_NEAR(closest({carried(1, 3.0), fixed(6.0, 3.0)}), 1.0, 1e-5);
  EXPECT_NEAR(closest({fixed(4.0, 3.0), fixed(4.0, 3.0)}), 3.4, 1e-5) << "fixed bodies may overlap each other";
}

TEST(ClearanceCheck, AnExhaustedBudgetLeavesItUnknown) {
  const Problem problem = weightless_problem({20.0, 70.0}, {60.0, 20.0}, 0.1, 0.05);
  const Budget spent(Budget::Clock::now());
  const ClearanceReport report = clearance_of(problem, parabolic_motion(problem, {0.0, 0.2}), spent);
  EXPECT_FALSE(report.collision_free);
  ASSERT_EQ(report.violations.size(), 1u);
  EXPECT_EQ(report.violations[0].kind, ViolationKind::kClearanceUnknown);
  EXPECT_LE(report.distance_query_count, 3);
}

/// Two parallel arms that carry many objects each, so that boxes around them overlap.
Problem crowded_problem(int objects) {
  Problem problem = paper_problem({60.0, 120.0}, {60.0, 120.0}, 0.1, 0.05);
  problem.arms[1].base.position.x() = 2.0;
  for (int i = 0; i < objects; ++i) {
    problem.objects.push_back({"object" + std::to_string(i), Capsule{{1.0, 0.1, 0.0}, {5.0, 0.1, 0.0}, 0.01},
                               AttachedPlacement{i % kArmCount, Eigen::Isometry3d::Identity(), 0.0}});
  }
  return problem;
}

TEST(ClearanceCheck, TheBudgetIsAskedBeforeEveryPair) {
  const Problem problem = crowded_problem(40);  // 441 pairs
  const Trajectory trajectory = resting_motion(problem, 5.0);
  int asked = 0;
  const Budget budget(Budget::Clock::time_point::max(), [&asked] { return ++asked > 10; });
  const ClearanceReport report = clearance_of(problem, trajectory, budget);
  EXPECT_LE(report.distance_query_count, 10);
  EXPECT_FALSE(report.collision_free);
  ASSERT_EQ(report.violations.size(), 1u);
  EXPECT_EQ(report.violations[0].kind, ViolationKind::kClearanceUnknown);
  EXPECT_TRUE(clearance_of(problem, trajectory).collision_free);
}

TEST(ClearanceCheck, ABudgetThatIsSpentAllowsNoQuery) {
  const Problem problem = crowded_problem(40);
  const Budget spent(Budget::Clock::now());
  const ClearanceReport report = clearance_of(problem, resting_motion(problem, 5.0), spent);
  EXPECT_EQ(report.distance_query_count, 0);
  EXPECT_FALSE(report.closest.has_value());
  ASSERT_EQ(report.violations.size(), 1u);
  EXPECT_EQ(report.violations[0].kind, ViolationKind::kClearanceUnknown);
}

TEST(ClearanceCheck, PairsThatNeverComeAsCloseAsOthersNeedNoQueries) {
  Problem problem = crowded_problem(40);
  problem.arms[1].base.position.x() = 100.0;
  for (Task& task : problem.tasks) task.start.position = 0.0;  // the arms point at each other
  const ClearanceReport report = clearance_of(problem, resting_motion(problem, 5.0));
  EXPECT_TRUE(report.collision_free);
  EXPECT_LT(report.distance_query_count, 5);
  EXPECT_GT(report.min_clearance, 80.0);
}

TEST(ClearanceCheck, ARestExactlyAtTheDemandedDistanceEndsAndIsNotCalledACollision) {
  Problem problem = paper_problem({90.0, 90.0}, {90.0, 90.0}, 0.1, 7.8);
  problem.arms[1].base.position.x() = 8.0;
  const ClearanceReport report = clearance_of(problem, resting_motion(problem, 5.0));
  for (const Violation& violation : report.violations) EXPECT_NEAR(violation.value, 7.8, 1e-6);
  EXPECT_LE(report.distance_query_count, kEvidenceQueries + 10);
}

}  // namespace
}  // namespace dualarm
