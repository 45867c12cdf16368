#include "core/fallback/steering.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/phase_plane/metered_system.h"
#include "tests/core/fallback/scenes.h"

namespace dualarm {
namespace {

const JointStates kFrom = at_rest({10.0 * kDegree, 40.0 * kDegree});
const JointStates kTo = at_rest({40.0 * kDegree, 10.0 * kDegree});

TEST(Steering, TakesTheTimeOfTheSlowerArm) {
  const ArmSystems arms(retreat_problem());
  EXPECT_NEAR(minimum_time(arms.both(), kFrom, kTo), 1.134967, 1e-6);  // theory, section 4
  const double first_alone = steering_time(arms.both(), kFrom, {kTo[0], kFrom[1]});
  const double second_alone = steering_time(arms.both(), kFrom, {kFrom[0], kTo[1]});
  EXPECT_EQ(steering_time(arms.both(), kFrom, kTo), std::max(first_alone, second_alone));
}

TEST(Steering, StandsStillWhereThereIsNowhereToGo) {
  const ArmSystems arms(retreat_problem());
  const auto profile = steer(*arms.both()[0], {0.3, 0.0}, {0.3, 0.0});
  ASSERT_TRUE(profile);
  EXPECT_EQ(profile->duration(), 0.0);
  EXPECT_EQ(steering_time(arms.both(), kFrom, kFrom), 0.0);
}

TEST(Steering, FindsNoWayOutOfTheJointRange) {
  const ArmSystems arms(retreat_problem());
  EXPECT_FALSE(steer(*arms.both()[0], {0.3, 0.0}, {4.0, 0.0}));
  EXPECT_TRUE(std::isinf(steering_time(arms.both(), kFrom, at_rest({4.0, 0.3}))));
}

TEST(Steering, OfAWeakArmPromisesLessThanItsMonotoneMotionTakes) {
  Problem problem = retreat_problem();
  problem.arms[0].torque = Interval{-25.0, 25.0};  // gravity needs up to 29.43
  const ArmSystems arms(problem);
  const JointStates from = at_rest({10.0 * kDegree, 0.5});
  const JointStates to = at_rest({20.0 * kDegree, 0.5});
  EXPECT_GT(steering_time(arms.both(), from, to), 0.0);
  EXPECT_GT(minimum_time(arms.both(), from, to), 0.0);
  EXPECT_LT(minimum_time(arms.both(), from, to), steering_time(arms.both(), from, to));
}

TEST(Steering, KnowsWhereNoMotionOfAnyKindExists) {
  Problem problem = retreat_problem();
  problem.arms[0].torque = Interval{-17.0, 17.0};  // 0.578 of gravity's most: nothing passes (theory, section 1.3)
  const ArmSystems arms(problem);
  EXPECT_TRUE(std::isinf(minimum_time(arms.both(), at_rest({0.1, 0.5}), at_rest({3.0, 0.5}))));
}

TEST(Steering, CutsAMotionAnywhereButBesideItsSwitches) {
  const ArmSystems arms(retreat_problem());
  const System& system = *arms.both()[0];
  const Profile motion = steer(system, {0.3, 0.2}, {1.4, -0.3}).value();
  const double turn = motion.arcs().front().end_time;
  for (const double share : {0.1, 0.35, 0.6, 0.9}) {
    const double time = share * motion.duration();
    const auto part = cut(system, motion, time);
    ASSERT_TRUE(part);
    EXPECT_NEAR(part->duration(), time, 1e-11);
    EXPECT_NEAR(part->goal(), motion.at(time).position, 1e-12);
    EXPECT_NEAR(part->at(0.5 * time).position, motion.at(0.5 * time).position, 1e-10);
  }
  EXPECT_FALSE(cut(system, motion, turn - 1e-8));
  EXPECT_FALSE(cut(system, motion, turn + 1e-8));
  EXPECT_FALSE(cut(system, motion, 0.0));
}

TEST(Steering, StretchesAMotionToADurationBetweenItsFastestAndOneWithAStop) {
  const ArmSystems arms(retreat_problem());
  const System& system = *arms.both()[0];
  const JointState from = {0.3, 0.4};
  const JointState to = {1.4, 0.4};
  const double fastest = steering_time(system, from, to);
  for (const double longer : {0.0, 0.05, 0.3, 0.6}) {
    const auto slow = stretched(system, from, to, fastest + longer);
    ASSERT_TRUE(slow) << longer;
    EXPECT_EQ(slow->size(), longer == 0.0 ? 1u : 2u);
    double duration = 0.0;
    JointState at = from;
    for (const Profile& part : *slow) {
      EXPECT_NEAR(part.start(), at.position, 1e-14);
      at = part.goal_state();
      duration += part.duration();
    }
    EXPECT_NEAR(duration, fastest + longer, 1e-12);
    EXPECT_EQ(at, to);
  }
  EXPECT_FALSE(stretched(system, from, to, 0.9 * fastest));
  EXPECT_FALSE(stretched(system, from, to, 100.0));
}

TEST(Steering, GivesUpStretchingWhenTheBudgetRunsOut) {
  const ArmSystems arms(retreat_problem());
  const MeteredSystem system(*arms.both()[0]);
  const JointState from = {0.3, 0.4};
  const JointState to = {1.4, 0.4};
  const double longer = steering_time(system, from, to) + 0.2;
  const long begin = system.count();
  ASSERT_TRUE(stretched(system, from, to, longer));
  const long whole = system.count() - begin;
  EXPECT_FALSE(stretched(system, from, to, longer, Budget({}, [] { return true; })));
  EXPECT_LT(system.count() - begin - whole, whole / 2);
}

TEST(Steering, HoldsOnlyWhereTorqueSufficesAndInsideTheRange) {
  Problem problem = retreat_problem();
  problem.arms[0].torque = Interval{-25.0, 25.0};
  const ArmSystems arms(problem);
  EXPECT_TRUE(can_hold(*arms.both()[0], {0.2, 0.0}));
  EXPECT_FALSE(can_hold(*arms.both()[0], {0.2, 0.1}));
  EXPECT_FALSE(can_hold(*arms.both()[0], {90.0 * kDegree, 0.0}));
  EXPECT_TRUE(can_hold(*arms.both()[1], {90.0 * kDegree, 0.0}));
  EXPECT_FALSE(can_hold(*arms.both()[1], {-0.01, 0.0}));
}

}  // namespace
}  // namespace dualarm
