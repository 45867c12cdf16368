#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPi = std::numbers::pi;
/// s: the table is printed with three decimals.
constexpr double kPrinted = 5.01e-4;

Arm unit_pendulum(double torque) {
  Arm arm;
  arm.name = "pendulum";
  arm.length = 1.0;
  arm.inertia = 1.0;
  arm.gravity = {1.0, 0.0};
  arm.torque = Interval{-torque, torque};
  arm.joint_range = {-10.0, 10.0};
  arm.velocity = {-kInfinity, kInfinity};
  return arm;
}

struct Row {
  double start;   // rad
  double torque;  // T/G
  double seconds;
  bool swings;
};

/// theory.md, section 1.3: the better of monotone and back-swing.
constexpr Row kTable[] = {{0.0, 0.60, 6.696, true},       {0.0, 0.76, 5.790, true},
                          {0.0, 0.80, 5.359, false},      {0.5 * kPi, 1.01, 5.872, true},
                          {0.5 * kPi, 1.05, 5.785, true}, {0.5 * kPi, 1.10, 5.062, false}};

TEST(SwingTable, IsReturnedToItsPrintedDigits) {
  for (const Row& row : kTable) {
    SCOPED_TRACE(testing::Message() << "T/G " << row.torque << " from " << row.start);
    const SingleJointArm system(unit_pendulum(row.torque));
    const auto answer = fastest_motion(system, row.start, kPi);
    const auto* motion = std::get_if<FastestMotion>(&answer);
    ASSERT_NE(motion, nullptr);
    EXPECT_NEAR(motion->profile.duration(), row.seconds, kPrinted);
    EXPECT_EQ(motion->profile.legs().size(), row.swings ? 2U : 1U);
  }
}

TEST(SwingTable, HoldsForTheMotionBackAndForTheMirroredArmToo) {
  for (const Row& row : kTable) {
    SCOPED_TRACE(testing::Message() << "T/G " << row.torque << " from " << row.start);
    const SingleJointArm system(unit_pendulum(row.torque));
    const auto back = fastest_motion(system, kPi, row.start);
    ASSERT_TRUE(std::holds_alternative<FastestMotion>(back));
    EXPECT_NEAR(std::get<FastestMotion>(back).profile.duration(), row.seconds, kPrinted);
    const auto mirrored = fastest_motion(system, -row.start, -kPi);
    ASSERT_TRUE(std::holds_alternative<FastestMotion>(mirrored));
    EXPECT_NEAR(std::get<FastestMotion>(mirrored).profile.duration(), row.seconds, kPrinted);
  }
}

TEST(SwingTable, ClaimsNoMoreThanTheFamilyItSearched) {
  // From the hanging start at 0.76 the monotone motion takes 6.191 s, the swing 5.790 s: a claim over monotone motions
  // would be true of neither answer.
  const SingleJointArm system(unit_pendulum(0.76));
  const auto answer = fastest_motion(system, 0.0, kPi);
  ASSERT_TRUE(std::holds_alternative<FastestMotion>(answer));
  EXPECT_NE(std::get<FastestMotion>(answer).minimum_over, MinimumOver::kMonotoneMotions);
  const auto skipped = fastest_motion(system, 0.0, kPi, Swings::kSkip);
  ASSERT_TRUE(std::holds_alternative<FastestMotion>(skipped));
  EXPECT_NEAR(std::get<FastestMotion>(skipped).profile.duration(), 6.191, kPrinted);
}

TEST(SwingTable, LosesItsSwingsToTheJointRange) {
  Arm arm = unit_pendulum(0.6);
  arm.joint_range = {0.0, kPi};
  const auto answer = fastest_motion(SingleJointArm(arm), 0.0, kPi);
  ASSERT_TRUE(std::holds_alternative<Blocked>(answer));
  EXPECT_EQ(std::get<Blocked>(answer).reason, BlockReason::kStalls);
  EXPECT_TRUE(std::get<Blocked>(answer).is_proven);
}

}  // namespace
}  // namespace dualarm
