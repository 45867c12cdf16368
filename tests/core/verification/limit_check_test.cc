#include "core/verification/limit_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/verification/joint_torque.h"
#include "tests/core/verification/sample_motions.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

using testing::IsEmpty;

LimitReport limits_of(const Arm& arm, const std::vector<Knot>& knots, const Budget& budget = Budget()) {
  const Interpolant motion(knots);
  const JointTorque torque(arm);
  return check_limits(arm, torque, NeededTorque(torque, motion), motion, budget);
}

TEST(LimitCheck, AMotionThatRidesOnTheTorqueLimitUnderGravityIsAtOneAndNotAbove) {
  for (const double period : {0.002, 0.01, 0.03}) {
    SCOPED_TRACE(period);
    Problem problem = paper_problem({20.0, 90.0}, {20.0, 90.0});
    problem.arms[0].gravity.phase = -0.7;
    const Trajectory trajectory = full_torque_motion(problem, 0.9, period);
    const LimitReport report = limits_of(problem.arms[0], trajectory[0].knots);
    EXPECT_THAT(report.violations, IsEmpty());
    EXPECT_NEAR(report.torque.value, 1.0, 1e-6);
    EXPECT_LT(report.velocity.value, 1.0);
  }
}

TEST(LimitCheck, SparseKnotsOfAFastestMotionDepartFromItAndSayTheTorque) {
  Problem problem = paper_problem({20.0, 90.0}, {20.0, 90.0});
  const Trajectory trajectory = full_torque_motion(problem, 0.9, 0.3);
  const LimitReport report = limits_of(problem.arms[0], trajectory[0].knots);
  ASSERT_EQ(report.violations.size(), 1u);
  EXPECT_EQ(report.violations[0].kind, ViolationKind::kTorque);
  EXPECT_GT(report.violations[0].value, 60.0);
  EXPECT_EQ(report.violations[0].limit, 60.0);
}

TEST(LimitCheck, APeakOfTorqueBetweenGoodKnotsIsFound) {
  const Arm arm = weightless_problem({0.0, 0.0}, {0.0, 0.0}).arms[0];
  // From rest to rest in one piece: the acceleration peaks at 10 / sqrt(3) d / T^2, and is 0 at both knots.
  const double change = 1.01 * 60.0 / 39.0 * std::sqrt(3.0) / 10.0;
  const LimitReport report = limits_of(arm, {{0.0, 0.0, 0.0, 0.0, 0.0}, {1.0, change, 0.0, 0.0, 0.0}});
  ASSERT_EQ(report.violations.size(), 1u);
  EXPECT_EQ(report.violations[0].kind, ViolationKind::kTorque);
  EXPECT_NEAR(report.torque.value, 1.01, 1e-6);
  EXPECT_NEAR(std::abs(report.torque.time - 0.5), 0.5 / std::sqrt(3.0), 1e-3);
}

TEST(LimitCheck, APeakOfVelocityBetweenGoodKnotsIsFound) {
  Arm arm = weightless_problem({0.0, 0.0}, {0.0, 0.0}).arms[0];
  arm.torque = Interval{-1e6, 1e6};
  const double change = 2.02 * 8.0 / 15.0;  // the velocity peaks at 15/8 d / T
  const LimitReport report = limits_of(arm, {{0.0, 0.0, 0.0, 0.0, 0.0}, {1.0, change, 0.0, 0.0, 0.0}});
  ASSERT_EQ(report.violations.size(), 1u);
  EXPECT_EQ(report.violations[0].kind, ViolationKind::kVelocity);
  EXPECT_NEAR(report.velocity.value, 1.01, 1e-6);
  EXPECT_NEAR(report.velocity.time, 0.5, 1e-3);
}

TEST(LimitCheck, AnOvershootOfTheRangeBetweenGoodKnotsIsFound) {
  Arm arm = weightless_problem({0.0, 0.0}, {0.0, 0.0}).arms[0];
  arm.joint_range = {-1.0, 0.01};
  // A toss: up with 1 rad/s, back at the same place; the top is at v^2 / (2 a) = v T / 4 = 0.025 rad.
  const LimitReport report = limits_of(arm, {{0.0, 0.0, 1.0, -20.0, 0.0}, {0.1, 0.0, -1.0, -20.0, 0.0}});
  ASSERT_FALSE(report.violations.empty());
  EXPECT_EQ(report.violations[0].kind, ViolationKind::kJointRange);
  EXPECT_NEAR(report.violations[0].value, 0.025, 1e-7);
}

TEST(LimitCheck, EndingExactlyAtTheEndOfTheRangeIsAllowed) {
  const Problem problem = weightless_problem({0.0, 90.0}, {180.0, 90.0});
  const LimitReport report = limits_of(problem.arms[0], parabolic_motion(problem, {0.0, 0.0})[0].knots);
  EXPECT_THAT(report.violations, testing::Each(testing::Field(&Violation::kind, ViolationKind::kVelocity)));
  EXPECT_NEAR(report.range.value, 1.0, 1e-7);
}

TEST(LimitCheck, AHoldThatTheDriveCanNotHoldIsATorqueViolation) {
  Problem problem = paper_problem({90.0, 90.0}, {90.0, 90.0});
  problem.arms[0].torque = Interval{-29.0, 29.0};  // 29.43 N m are needed
  const LimitReport report = limits_of(problem.arms[0], resting_motion(problem, 2.0)[0].knots);
  ASSERT_EQ(report.violations.size(), 1u);
  EXPECT_NEAR(report.torque.value, 29.43 / 29.0, 1e-12);
}

TEST(LimitCheck, RoundingBeyondASideOfNextToNothingIsNoViolation) {
  for (const double lower : {0.0, -1e-300, -1e-9}) {
    SCOPED_TRACE(lower);
    Problem problem = paper_problem({180.0, 90.0}, {180.0, 90.0});
    std::get<Interval>(problem.arms[0].torque).lower = lower;
    std::vector<Knot> knots = resting_motion(problem, 2.0)[0].knots;
    for (Knot& knot : knots) knot.acceleration = (lower - 9e-16) / problem.arms[0].inertia;
    EXPECT_THAT(limits_of(problem.arms[0], knots).violations, IsEmpty());
    for (Knot& knot : knots) knot.acceleration = (lower - 1e-3) / problem.arms[0].inertia;
    EXPECT_EQ(limits_of(problem.arms[0], knots).violations.size(), 1u);
  }
}

TEST(LimitCheck, AJumpOfVelocityInAShortPieceIsATorqueHoweverLateItIs) {
  const Arm arm = weightless_problem({0.0, 0.0}, {0.0, 0.0}).arms[0];
  for (const double at : {10.0, 1e3, 1e5}) {
    SCOPED_TRACE(at);
    std::vector<Knot> knots = {{at, 0.5, 1.0, 0.0, 0.0}};
    constexpr double kStep = 2e-7;
    constexpr double kFaster = 1e-4;  // rad/s in each piece, 0.05 rad/s in all
    for (int k = 0; k < 500; ++k) {
      const Knot& last = knots.back();
      const double next = last.time + kStep;
      const double way = (last.velocity + 0.5 * kFaster) * (next - last.time);
      knots.push_back({next, last.position + way, last.velocity + kFaster, 0.0, 0.0});
    }
    const LimitReport report = limits_of(arm, knots);
    ASSERT_FALSE(report.violations.empty());
    EXPECT_EQ(report.violations.back().kind, ViolationKind::kTorque);
  }
}

TEST(LimitCheck, ALeapInAShortPieceIsAVelocityHoweverLateItIs) {
  const Arm arm = weightless_problem({0.0, 0.0}, {0.0, 0.0}).arms[0];
  for (const double at : {10.0, 500.0, 1e3}) {
    SCOPED_TRACE(at);
    const double after = at + 1.02e-12;
    const LimitReport report =
        limits_of(arm, {{0.0, 0.1, 0.0, 0.0, 0.0}, {at, 0.1, 0.0, 0.0, 0.0}, {after, 0.8, 0.0, 0.0, 0.0}});
    ASSERT_FALSE(report.violations.empty());
    EXPECT_EQ(report.violations.front().kind, ViolationKind::kVelocity);
  }
}

TEST(LimitCheck, AFastVelocityIsNotExcusedByRounding) {
  Arm arm = weightless_problem({0.0, 0.0}, {0.0, 0.0}).arms[0];
  const double speed = 1.001 * arm.velocity.upper;
  arm.torque = Interval{-1e12, 1e12};
  const double at = 1e6;
  const double after = at + 1e-7;
  const double mean = 15.0 / 8.0 * (speed - arm.velocity.upper) + arm.velocity.upper;
  const double start = 0.1;
  const double end = start + mean * (after - at);
  const LimitReport report =
      limits_of(arm, {{at, start, arm.velocity.upper, 0.0, 0.0}, {after, end, arm.velocity.upper, 0.0, 0.0}});
  ASSERT_FALSE(report.violations.empty());
  EXPECT_EQ(report.violations.front().kind, ViolationKind::kVelocity);
}

TEST(LimitCheck, AnExhaustedBudgetIsNotAProof) {
  const Problem problem = weightless_problem({20.0, 90.0}, {60.0, 90.0});
  const std::vector<Knot> knots = parabolic_motion(problem, {0.0, 0.0})[0].knots;
  EXPECT_TRUE(limits_of(problem.arms[0], knots).is_complete);
  const Budget spent(Budget::Clock::now());
  EXPECT_FALSE(limits_of(problem.arms[0], knots, spent).is_complete);
}

}  // namespace
}  // namespace dualarm
