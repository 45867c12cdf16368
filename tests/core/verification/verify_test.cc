#include "core/verification/verify.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

#include "tests/core/verification/sample_motions.h"
#include "tests/support/independent_check.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

using testing::IsEmpty;
using testing::Not;

void expect_holds(const Verification& verification) {
  for (const Violation& violation : verification.violations) ADD_FAILURE() << violation.explanation;
  EXPECT_TRUE(verification.holds());
}

TEST(Verify, AcceptsAGoodMotionAndReportsWhatItUses) {
  const Problem problem = weightless_problem({20.0, 70.0}, {60.0, 20.0}, 0.1, 0.05);
  const Trajectory trajectory = parabolic_motion(problem, {0.0, 0.2});
  const Verification verification = verify(problem, trajectory, Budget());
  expect_holds(verification);
  EXPECT_NEAR(verification.min_clearance, 0.090791, 1e-5);
  EXPECT_NEAR(verification.torque.value, 1.0, 1e-6);
  EXPECT_NEAR(verification.velocity.value, 1.158689 / 2.0, 1e-5);
  EXPECT_EQ(verification.velocity.arm, "arm2");
  EXPECT_NEAR(verification.range.value, 7.0 / 9.0, 1e-6);
  EXPECT_LT(verification.max_position_error, 1e-12);
  EXPECT_THAT(independent_check(problem, trajectory), IsEmpty());
}

TEST(Verify, AcceptsARestThatTakesNoTime) {
  const Problem problem = paper_problem({60.0, 120.0}, {60.0, 120.0}, 0.1, 0.05);
  Trajectory trajectory = resting_motion(problem, 0.0);
  expect_holds(verify(problem, trajectory, Budget()));
  for (ArmTrajectory& motion : trajectory) motion.arcs.clear();
  expect_holds(verify(problem, trajectory, Budget()));
}

TEST(Verify, AcceptsALongRest) {
  const Problem problem = paper_problem({60.0, 120.0}, {60.0, 120.0}, 0.1, 0.05);
  const Verification verification = verify(problem, resting_motion(problem, 3600.0), Budget());
  expect_holds(verification);
  EXPECT_EQ(verification.velocity.value, 0.0);
}

TEST(Verify, AcceptsAMotionOnTheTorqueLimitUnderGravity) {
  Problem problem = paper_problem({20.0, 120.0}, {20.0, 120.0}, 0.1, 0.05);
  const Trajectory trajectory = full_torque_motion(problem, 0.9, 0.01);
  const Verification verification = verify(problem, trajectory, Budget());
  expect_holds(verification);
  EXPECT_LT(verification.max_position_error, 1e-9);
  EXPECT_THAT(independent_check(problem, trajectory), IsEmpty());
}

TEST(Verify, LooksAtEndStatesOnlyIfAskedTo) {
  Problem problem = weightless_problem({20.0, 70.0}, {60.0, 20.0}, 0.1, 0.05);
  const Trajectory trajectory = parabolic_motion(problem, {0.0, 0.2});
  problem.tasks[0].goal.position += 0.1;
  EXPECT_FALSE(verify(problem, trajectory, Budget()).holds());
  expect_holds(verify(problem, trajectory, Budget(), false));
}

TEST(Verify, AMotionThatIsNoneIsNeverCalledFree) {
  const Problem problem = weightless_problem({20.0, 70.0}, {60.0, 20.0}, 0.1, 0.05);
  const Verification verification = verify(problem, Trajectory{}, Budget());
  EXPECT_FALSE(verification.collision_free);
  EXPECT_THAT(verification.violations, Not(IsEmpty()));
}

TEST(Verify, ASpentBudgetProvesNothing) {
  const Problem problem = paper_problem({60.0, 120.0}, {60.0, 120.0}, 0.1, 0.05);
  const Verification verification = verify(problem, resting_motion(problem, 1.0), Budget(Budget::Clock::now()));
  EXPECT_FALSE(verification.holds());
}

TEST(Verify, InfiniteVelocityLimitsAreNoLimits) {
  Problem problem = weightless_problem({20.0, 70.0}, {60.0, 20.0}, 0.1, 0.05);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (Arm& arm : problem.arms) arm.velocity = {-kInfinity, kInfinity};
  const Verification verification = verify(problem, parabolic_motion(problem, {0.0, 0.2}), Budget());
  expect_holds(verification);
  EXPECT_EQ(verification.velocity.value, 0.0);
}

/// Arm 1 passes its start with 0.5 rad/s and its goal with some other velocity, when arm 2 has rested for as long.
Trajectory moving_ends(Problem& problem) {
  problem = paper_problem({20.0, 150.0}, {20.0, 150.0}, 0.1, 0.05);
  problem.tasks[0].start.velocity = 0.5;
  return driven_motion(problem, {{Effort::kUpward, 0.5}}, 0.01);
}

TEST(Verify, AcceptsEndsThatMove) {
  for (const Effort effort : {Effort::kUpward, Effort::kDownward, Effort::kSteady}) {
    for (const double velocity : {0.6, -0.2}) {
      SCOPED_TRACE(velocity);
      Problem problem = paper_problem({20.0, 150.0}, {20.0, 150.0}, 0.1, 0.05);
      problem.tasks[0].start.velocity = velocity;
      const Trajectory trajectory = driven_motion(problem, {{effort, 0.5}}, 0.01);
      EXPECT_NE(problem.tasks[0].goal.velocity, 0.0);
      expect_holds(verify(problem, trajectory, Budget()));
      EXPECT_THAT(independent_check(problem, trajectory), IsEmpty());
    }
  }
}

TEST(Verify, AcceptsAMovingStateThatTakesNoTime) {
  Problem problem = paper_problem({60.0, 120.0}, {60.0, 120.0}, 0.1, 0.05);
  problem.tasks[0] = {{1.0, 0.7}, {1.0, 0.7}};
  Trajectory trajectory = resting_motion(problem, 0.0);
  trajectory[0].arcs.clear();
  const Knot passing = {0.0, 1.0, 0.7, 0.0, problem.arms[0].gravity.amplitude * std::sin(1.0)};
  trajectory[0].knots = {passing, passing};
  expect_holds(verify(problem, trajectory, Budget()));
}

TEST(Verify, AnArmThatIsToArriveMovingArrivesWhenThePlanEnds) {
  Problem problem;
  const Trajectory good = moving_ends(problem);
  expect_holds(verify(problem, good, Budget()));
  const double end = good[0].knots.back().time;
  const auto with_later_end = [&](std::initializer_list<Knot> more) {
    Trajectory late = good;
    for (Knot& knot : late[1].knots) knot.time *= (end + 0.1) / end;
    late[1].arcs.front().end_time = end + 0.1;
    late[0].knots.insert(late[0].knots.end(), more);
    return verify(problem, late, Budget());
  };
  const auto has = [](ViolationKind kind) { return testing::Contains(testing::Field(&Violation::kind, kind)); };
  Knot arrived = good[0].knots.back();
  Knot still = arrived;
  still.velocity = 0.0;
  still.acceleration = 0.0;
  Knot later = still;
  later.time = end + 0.1;
  EXPECT_THAT(with_later_end({still, later}).violations, has(ViolationKind::kContinuity)) << "stops dead";
  Knot coasted = arrived;
  coasted.time = end + 0.1;
  coasted.position += 0.1 * arrived.velocity;
  EXPECT_THAT(with_later_end({coasted}).violations, has(ViolationKind::kEndState)) << "coasts on";
  EXPECT_THAT(with_later_end({coasted}).violations, has(ViolationKind::kArc)) << "after its duration";
  Knot again = arrived;
  again.time = end + 0.1;
  const Verification verification = with_later_end({again});
  EXPECT_THAT(verification.violations, Not(has(ViolationKind::kEndState))) << "it comes back in time";
  EXPECT_THAT(verification.violations, has(ViolationKind::kArc)) << "but said that it had arrived";
}

TEST(Verify, AnArmThatStartsMovingDoesNotWait) {
  Problem problem;
  Trajectory trajectory = moving_ends(problem);
  trajectory[0].start_time = 0.05;
  trajectory[0].duration -= 0.05;
  const Verification verification = verify(problem, trajectory, Budget());
  ASSERT_EQ(verification.violations.size(), 1u);
  EXPECT_EQ(verification.violations[0].kind, ViolationKind::kArc);
}

TEST(Verify, AgreesWithTheIndependentCheckOnRandomDrives) {
  int accepted = 0;
  for (const DriveModel model : kDriveModels) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      SCOPED_TRACE(testing::Message() << name_of(model) << ", seed " << seed);
      Problem problem = with_moving_ends(random_problem(seed, model, seed % 2 == 0), seed, 0.5);
      problem.tasks[1] = {{problem.tasks[1].start.position, 0.0}, {problem.tasks[1].start.position, 0.0}};
      const Trajectory trajectory =
          driven_motion(problem, {{Effort::kUpward, 0.4}, {Effort::kDownward, 0.5}, {Effort::kUpward, 0.1}}, 0.002);
      if (seed % 4 == 3) {
        if (auto* line = std::get_if<TorqueSpeedLine>(&problem.arms[0].torque)) line->no_load_speed *= 0.9;
        problem.arms[0].viscous_friction += 0.01 * torque_bounds(problem.arms[0].torque).upper;
      }
      const Verification verification = verify(problem, trajectory, Budget());
      const bool seen_by_samples = !independent_check(problem, trajectory).empty();
      EXPECT_EQ(verification.holds(), !seen_by_samples);
      accepted += verification.holds() ? 1 : 0;
    }
  }
  EXPECT_GT(accepted, 40);
  EXPECT_LT(accepted, 80);
}

TEST(Verify, AgreesWithTheIndependentCheckOnRandomMotions) {
  int accepted = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Problem problem = random_problem(seed);
    for (Arm& arm : problem.arms) arm.gravity = {};
    const Trajectory trajectory = parabolic_motion(problem, {0.05 * static_cast<double>(seed % 7), 0.0});
    const bool holds = verify(problem, trajectory, Budget()).holds();
    EXPECT_EQ(holds, independent_check(problem, trajectory).empty());
    accepted += holds ? 1 : 0;
  }
  EXPECT_GT(accepted, 10);
  EXPECT_LT(accepted, 90);
}

}  // namespace
}  // namespace dualarm
