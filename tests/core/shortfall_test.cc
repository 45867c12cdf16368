#include "core/shortfall.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/refuse_blocked.h"
#include "tests/core/phase_plane/test_arms.h"

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;

/// Gravity takes 5 N m of the drive's 4 between asin(0.8) and pi - asin(0.8).
Arm weak_arm(Interval range, double velocity) {
  Arm arm = pendulum(1.0, 5.0, 4.0);
  arm.joint_range = range;
  arm.velocity = {-velocity, velocity};
  return arm;
}

bool moves(const Arm& arm, const Task& task) {
  return std::holds_alternative<FastestMotion>(fastest_motion(SingleJointArm(arm), task.start, task.goal));
}

struct Case {
  const char* name;
  Arm arm;
  Task task;
  InfeasibleReason reason;
  WidenedLimit limit;
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

class RelaxationOf : public ::testing::TestWithParam<Case> {};

TEST_P(RelaxationOf, IsEnoughAndAHundredthLessIsNot) {
  const auto& [name, arm, task, reason, limit] = GetParam();
  const SingleJointArm system(arm);
  const auto motion = fastest_motion(system, task.start, task.goal);
  ASSERT_TRUE(std::holds_alternative<Blocked>(motion));
  const Infeasible refusal =
      refuse_blocked(arm, task, system, {arm.joint_range, {}, {}, {}, {}}, std::get<Blocked>(motion));
  SCOPED_TRACE(refusal.explanation);
  EXPECT_EQ(refusal.reason, reason);
  ASSERT_TRUE(refusal.evidence.relaxation);
  const double amount = *refusal.evidence.relaxation;
  SCOPED_TRACE(amount);
  EXPECT_TRUE(moves(with_wider(arm, limit, amount * (1.0 + 1e-3)), task));
  EXPECT_FALSE(moves(with_wider(arm, limit, amount * (1.0 - 1e-2)), task));
}

Arm with(Arm arm, TorqueLimit torque) {
  arm.torque = std::move(torque);
  return arm;
}

Arm with_friction(Arm arm, double friction) {
  arm.viscous_friction = friction;
  return arm;
}

const TorqueTable kTable = {{0.5, 2.5}, {-1.0, 1.0}, {{-4.0, 4.5}, {-4.2, 4.0}, {-4.0, 4.0}, {-4.0, 3.8}}};

INSTANTIATE_TEST_SUITE_P(Shortfall, RelaxationOf,
                         ::testing::Values(Case{"velocity down",
                                                weak_arm({0.0, kPi}, 1.0),
                                                {{3.0, 0.0}, {0.1, 0.0}},
                                                InfeasibleReason::kVelocityLimit,
                                                WidenedLimit::kVelocity},
                                           Case{"velocity up",
                                                weak_arm({0.0, kPi}, 1.0),
                                                {{0.1, 0.0}, {3.0, 0.0}},
                                                InfeasibleReason::kVelocityLimit,
                                                WidenedLimit::kVelocity},
                                           Case{"velocity from a moving start",
                                                weak_arm({0.0, 2.9}, 1.0),
                                                {{2.0, -0.9}, {0.5, 0.0}},
                                                InfeasibleReason::kVelocityLimit,
                                                WidenedLimit::kVelocity},
                                           Case{"velocity with friction",
                                                with_friction(weak_arm({0.0, kPi}, 1.0), 0.1),
                                                {{3.0, 0.0}, {0.1, 0.0}},
                                                InfeasibleReason::kVelocityLimit,
                                                WidenedLimit::kVelocity},
                                           Case{"velocity on a table",
                                                with(weak_arm({0.0, kPi}, 1.0), kTable),
                                                {{3.0, 0.0}, {0.1, 0.0}},
                                                InfeasibleReason::kVelocityLimit,
                                                WidenedLimit::kVelocity},
                                           Case{"torque beside the weak places",
                                                weak_arm({0.5, 2.9}, 1.0),
                                                {{2.9, 0.0}, {0.927, 0.0}},
                                                InfeasibleReason::kTorqueTooSmall,
                                                WidenedLimit::kTorque},
                                           Case{"torque from the range's end",
                                                weak_arm({0.5, 2.9}, HUGE_VAL),
                                                {{0.5, 0.0}, {2.9, 0.0}},
                                                InfeasibleReason::kTorqueTooSmall,
                                                WidenedLimit::kTorque},
                                           Case{"torque with room to swing",
                                                weak_arm({0.3, 2.9}, HUGE_VAL),
                                                {{0.5, 0.0}, {2.9, 0.0}},
                                                InfeasibleReason::kTorqueTooSmall,
                                                WidenedLimit::kTorque},
                                           Case{"torque of a line",
                                                with(weak_arm({0.5, 2.9}, HUGE_VAL), TorqueSpeedLine{4.0, 50.0}),
                                                {{2.9, 0.0}, {0.5, 0.0}},
                                                InfeasibleReason::kTorqueTooSmall,
                                                WidenedLimit::kTorque},
                                           Case{"torque that holds the start",
                                                weak_arm({0.0, kPi}, HUGE_VAL),
                                                {{1.5, 0.0}, {0.1, 0.0}},
                                                InfeasibleReason::kStartNotHoldable,
                                                WidenedLimit::kTorque},
                                           Case{"torque that holds the goal",
                                                weak_arm({0.0, kPi}, HUGE_VAL),
                                                {{0.1, 0.0}, {1.5, 0.0}},
                                                InfeasibleReason::kGoalNotHoldable,
                                                WidenedLimit::kTorque},
                                           Case{"less than a drive gives",
                                                with(weak_arm({-7.0, 7.0}, HUGE_VAL), Interval{2.0, 60.0}),
                                                {{0.0, 0.0}, {1.0, 0.0}},
                                                InfeasibleReason::kStartNotHoldable,
                                                WidenedLimit::kTorque},
                                           Case{"room for a start",
                                                with(weak_arm({0.0, kPi}, 2.0), Interval{-8.0, 8.0}),
                                                {{3.0, 1.9}, {1.0, 0.0}},
                                                InfeasibleReason::kStartTooFast,
                                                WidenedLimit::kRangeAbove},
                                           Case{"room for a goal",
                                                with(weak_arm({0.0, kPi}, 2.0), Interval{-8.0, 8.0}),
                                                {{1.0, 0.0}, {0.1, 1.9}},
                                                InfeasibleReason::kGoalTooFast,
                                                WidenedLimit::kRangeBelow},
                                           Case{"speed of a start",
                                                with(weak_arm({0.0, kPi}, 2.0), Interval{-8.0, 8.0}),
                                                {{1.0, 2.5}, {2.5, 0.0}},
                                                InfeasibleReason::kStartTooFast,
                                                WidenedLimit::kVelocity},
                                           Case{"range of a goal",
                                                with(weak_arm({0.0, kPi}, 2.0), Interval{-8.0, 8.0}),
                                                {{1.0, 0.0}, {3.4, 0.0}},
                                                InfeasibleReason::kGoalOutsideRange,
                                                WidenedLimit::kRangeAbove}));

TEST(Shortfall, IsNotKnownWhereNoAmountIsEnough) {
  // However much torque: gravity cannot be held at a start that lies outside the range.
  const Arm arm = weak_arm({0.0, kPi}, 1.0);
  EXPECT_FALSE(shortfall(arm, {{4.0, 0.0}, {1.0, 0.0}}, WidenedLimit::kTorque, std::nullopt, Budget()));
}

TEST(Shortfall, IsFoundAllTheSameWhereAGuessIsWrong) {
  const Arm arm = weak_arm({0.0, kPi}, 1.0);
  const Task task = {{3.0, 0.0}, {0.1, 0.0}};
  const auto found = shortfall(arm, task, WidenedLimit::kVelocity, std::nullopt, Budget());
  ASSERT_TRUE(found);
  for (const double wrong : {0.5 * *found, 2.0 * *found}) {
    EXPECT_NEAR(shortfall(arm, task, WidenedLimit::kVelocity, wrong, Budget()).value(), *found, 1e-6 * *found);
  }
}

TEST(Shortfall, EndsWithTheBudget) {
  const Budget over(Budget::Clock::now());
  EXPECT_FALSE(
      shortfall(weak_arm({0.0, kPi}, 1.0), {{3.0, 0.0}, {0.1, 0.0}}, WidenedLimit::kVelocity, std::nullopt, over));
}

}  // namespace
}  // namespace dualarm
