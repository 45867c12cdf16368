#include "core/verification/verify.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
