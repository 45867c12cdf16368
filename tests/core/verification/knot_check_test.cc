#include "core/verification/knot_check.h"

#include <gtest/gtest.h>

#include "tests/core/verification/sample_motions.h"

namespace dualarm {
namespace {

/// Rest, then `count` knots `step` s and `leap` rad (`faster` rad/s) apart from `at` on, then rest until 2 `at`.
std::vector<Violation> violations_of_chain(double at, int count, double step, double leap, double faster = 0.0) {
  const Problem problem = weightless_problem({0.0, 90.0}, {0.0, 90.0});
  Trajectory trajectory = resting_motion(problem, 2.0 * at);
  std::vector<Knot>& knots = trajectory[0].knots;
  knots.pop_back();
  for (int k = 0; k <= count; ++k) knots.push_back({at + k * step, k * leap, k * faster, 0.0, 0.0});
  knots.push_back({2.0 * at, count * leap, count * faster, 0.0, 0.0});
  return check_knots(problem, trajectory);
}

TEST(KnotCheck, ManySmallJumpsAtOneTimeAreOneLargeJump) {
  EXPECT_TRUE(violations_of_chain(3.0, 1, 0.0, 0.99e-9).empty());
  for (const double step : {0.0, 0.9e-12}) {
    SCOPED_TRACE(step);
    for (const auto& violations :
         {violations_of_chain(3.0, 2000, step, 0.99e-9), violations_of_chain(3.0, 2000, step, 0.0, 0.99e-9)}) {
      ASSERT_EQ(violations.size(), 1u);
      EXPECT_EQ(violations[0].kind, ViolationKind::kContinuity);
    }
  }
}

TEST(KnotCheck, SmallJumpsAtManyTimesAddUp) {
  const Problem problem = weightless_problem({0.0, 90.0}, {0.0, 90.0});
  Trajectory trajectory = resting_motion(problem, 1.0);
  std::vector<Knot>& knots = trajectory[0].knots;
  knots.clear();
  for (int k = 0; k < 100; ++k) {
    knots.push_back({k / 99.0, k * 0.5e-9, 0.0, 0.0, 0.0});
    knots.push_back({k / 99.0, (k + 1) * 0.5e-9, 0.0, 0.0, 0.0});
  }
  const std::vector<Violation> violations = check_knots(problem, trajectory);
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_EQ(violations[0].kind, ViolationKind::kContinuity);
}

TEST(KnotCheck, KnotsShareATimeOrAreFarEnoughApart) {
  for (const double step : {1.5e-12, 5e-12, 0.9e-11}) {
    SCOPED_TRACE(step);
    const std::vector<Violation> violations = violations_of_chain(3.0, 100, step, 0.99e-9);
    ASSERT_EQ(violations.size(), 1u);
    EXPECT_EQ(violations[0].kind, ViolationKind::kKnotOrder);
  }
  EXPECT_TRUE(violations_of_chain(3.0, 100, 1.1e-11, 0.99e-9).empty());
}

TEST(KnotCheck, ALeapBetweenTimesThatDifferByRoundingIsAJump) {
  const std::vector<Violation> violations = violations_of_chain(1000.0, 1, 1.02e-12, 0.698);
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_NE(violations[0].explanation, "");
  EXPECT_TRUE(violations_of_chain(1e5, 3, 1.5e-11, 0.0).empty()) << "the same state at a time that was rounded twice";
}

}  // namespace
}  // namespace dualarm
