#include "core/phase_plane/one_switch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <variant>

#include "core/phase_plane/profile.h"
#include "core/phase_plane/turns.h"
#include "core/systems/single_joint_arm.h"
#include "tests/core/phase_plane/test_arms.h"
#include "tests/support/dice.h"

namespace dualarm {
namespace {

/// What walking along both curves finds, if just one of the two ways leads to the goal.
std::optional<std::vector<Arc>> only_way(const System& system, JointState start, JointState goal) {
  std::optional<std::vector<Arc>> found;
  for (const double direction : {1.0, -1.0}) {
    const auto way = one_way_motion(system, start, goal, direction);
    const auto* arcs = way ? std::get_if<std::vector<Arc>>(&*way) : nullptr;
    if (arcs == nullptr) continue;
    if (found) return std::nullopt;
    found = *arcs;
  }
  return found;
}

void expect_near(JointState found, JointState expected) {
  EXPECT_NEAR(found.position, expected.position, 1e-12);
  EXPECT_NEAR(found.velocity, expected.velocity, 1e-11);
}

Arm strong_arm(Dice& dice) {
  const double gravity = dice.between(0.0, 40.0);
  Arm arm = pendulum(dice.between(0.1, 50.0), gravity, gravity + dice.between(1.0, 60.0));
  arm.gravity.phase = dice.between(-3.0, 3.0);
  return arm;
}

TEST(OneSwitch, IsTheMotionThatWalkingAlongBothCurvesFinds) {
  constexpr unsigned kSeed = 41;
  SCOPED_TRACE(kSeed);
  Dice dice(kSeed);
  int answered = 0;
  for (int round = 0; round < 2000; ++round) {
    SCOPED_TRACE(round);
    const SingleJointArm system(strong_arm(dice));
    const JointState start = {dice.between(-3.0, 3.0), dice.happens(0.5) ? 0.0 : dice.between(-3.0, 3.0)};
    const JointState goal = {dice.between(-3.0, 3.0), dice.happens(0.5) ? 0.0 : dice.between(-3.0, 3.0)};
    const auto arcs = one_switch_motion(system, start, goal);
    if (!arcs) continue;
    ++answered;
    const auto walked = only_way(system, start, goal);
    ASSERT_TRUE(walked);
    ASSERT_EQ(arcs->size(), walked->size());
    for (std::size_t i = 0; i < arcs->size(); ++i) {
      EXPECT_EQ((*arcs)[i].kind, (*walked)[i].kind);
      expect_near((*arcs)[i].start, (*walked)[i].start);
      expect_near((*arcs)[i].end, (*walked)[i].end);
    }
  }
  EXPECT_GT(answered, 1800);
}

/// From a state on the way the rest of a motion is the fastest, though its switch lies in that state: the loop to and
/// fro that the other order of torques would lead along from there must not be taken for it.
TEST(OneSwitch, NeverAnswersALoopFromAStateOnTheWay) {
  constexpr unsigned kSeed = 43;
  SCOPED_TRACE(kSeed);
  Dice dice(kSeed);
  int answered = 0;
  for (int round = 0; round < 500; ++round) {
    SCOPED_TRACE(round);
    const SingleJointArm system(strong_arm(dice));
    const JointState start = {dice.between(-3.0, 3.0), dice.between(-3.0, 3.0)};
    const JointState goal = {dice.between(-3.0, 3.0), dice.between(-3.0, 3.0)};
    const auto way = one_switch_motion(system, start, goal);
    if (!way) continue;
    const Profile whole(system, *way);
    for (int i = 0; i <= 20; ++i) {
      const double time = whole.duration() * i / 20.0;
      const auto rest = one_switch_motion(system, whole.at(time), goal);
      const auto until = one_switch_motion(system, start, whole.at(time));
      if (rest) {
        EXPECT_NEAR(Profile(system, *rest).duration(), whole.duration() - time, 1e-9);
      }
      if (until) {
        EXPECT_NEAR(Profile(system, *until).duration(), time, 1e-9);
      }
      answered += rest ? 1 : 0;
    }
  }
  EXPECT_GT(answered, 2000);
}

TEST(OneSwitch, LeavesWhatMeetsTheVelocityLimitOrTheRangeToOthers) {
  Arm arm = pendulum(1.0, 0.0, 4.0);
  EXPECT_TRUE(one_switch_motion(SingleJointArm(arm), {0.0, 0.0}, {3.0, 0.0}));
  arm.velocity = {-4.0, 3.4};  // the peak would be sqrt(12)
  EXPECT_FALSE(one_switch_motion(SingleJointArm(arm), {0.0, 0.0}, {3.0, 0.0}));
  arm.velocity = {-4.0, 4.0};
  arm.joint_range = {0.0, 3.4};  // stopping from 2 rad/s takes 0.5 rad
  EXPECT_FALSE(one_switch_motion(SingleJointArm(arm), {3.0, 2.0}, {2.0, 0.0}));
  arm.joint_range = {0.0, 3.6};
  EXPECT_TRUE(one_switch_motion(SingleJointArm(arm), {3.0, 2.0}, {2.0, 0.0}));
}

TEST(OneSwitch, LeavesWeakDrivesFrictionAndShortArcsToOthers) {
  const JointState start = {0.5, 0.0};
  const JointState goal = {2.0, 0.0};
  EXPECT_TRUE(one_switch_motion(SingleJointArm(pendulum(1.0, 1.0, 1.2)), start, goal));
  EXPECT_FALSE(one_switch_motion(SingleJointArm(pendulum(1.0, 1.0, 0.9)), start, goal));
  Arm rubbing = pendulum(1.0, 1.0, 1.2);
  rubbing.viscous_friction = 0.1;
  EXPECT_FALSE(one_switch_motion(SingleJointArm(rubbing), start, goal));
  EXPECT_FALSE(one_switch_motion(SingleJointArm(pendulum(1.0, 1.0, 1.2)), start, {0.5 + 1e-8, 0.0}));
}

}  // namespace
}  // namespace dualarm
