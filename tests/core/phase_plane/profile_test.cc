#include "core/phase_plane/profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"
#include "tests/core/phase_plane/test_arms.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class ProfileTest : public testing::TestWithParam<std::pair<double, double>> {
 protected:
  static Arm arm() {
    Arm arm = pendulum(39.0, 29.43, 60.0);
    arm.velocity = {-1.2, 1.2};
    return arm;
  }

  SingleJointArm system_{arm()};
  Profile profile_ = std::get<FastestMotion>(fastest_motion(system_, GetParam().first, GetParam().second)).profile;
};

TEST_P(ProfileTest, PositionAndTimeAreInverse) {
  for (int i = 0; i <= 200; ++i) {
    const double time = profile_.duration() * i / 200.0;
    EXPECT_NEAR(profile_.time_at(profile_.legs().front(), profile_.at(time).position), time, 2e-8 * profile_.duration())
        << time;
  }
}

TEST_P(ProfileTest, VelocityIsTheSlopeOfThePosition) {
  const double h = 1e-5;
  for (int i = 1; i < 100; ++i) {
    const double time = profile_.duration() * i / 100.0;
    const double slope = (profile_.at(time + h).position - profile_.at(time - h).position) / (2.0 * h);
    EXPECT_NEAR(profile_.at(time).velocity, slope, 2e-5) << time;
  }
}

TEST_P(ProfileTest, PassesPositionsWithTheVelocityOfItsClock) {
  const Leg& leg = profile_.legs().front();
  for (int i = 1; i < 100; ++i) {
    const JointState state = profile_.at(profile_.duration() * i / 100.0);
    EXPECT_NEAR(profile_.velocity_at(leg, state.position), state.velocity, 1e-9) << i;
  }
  EXPECT_EQ(profile_.velocity_at(leg, leg.start), 0.0);
  EXPECT_EQ(profile_.velocity_at(leg, leg.goal), 0.0);
}

TEST_P(ProfileTest, StandsStillOutsideItsClock) {
  EXPECT_EQ(profile_.at(-1.0), (JointState{GetParam().first, 0.0}));
  EXPECT_EQ(profile_.at(profile_.duration() + 1.0), (JointState{GetParam().second, 0.0}));
}

TEST_P(ProfileTest, IsInAnIntervalForAsLongAsItsClockSays) {
  const double middle = 0.5 * (profile_.start() + profile_.goal());
  const auto [low, high] = std::minmax({middle, profile_.goal()});
  const IntervalSet times = profile_.times_in({low, high});
  ASSERT_EQ(times.intervals().size(), 1U);
  EXPECT_NEAR(times.intervals()[0].lower, profile_.time_at(profile_.legs().front(), middle), 1e-12);
  EXPECT_EQ(times.intervals()[0].upper, kInfinity);
  EXPECT_TRUE(profile_.times_in({20.0, 21.0}).empty());
  EXPECT_EQ(profile_.times_in({-20.0, 20.0}).intervals(), (std::vector<Interval>{{-kInfinity, kInfinity}}));
}

TEST_P(ProfileTest, PassesAStateNearATimeExactlyWhenItSays) {
  for (int i = -10; i <= 210; ++i) {
    const double time = profile_.duration() * i / 200.0;
    const TimedState passed = profile_.passed_near(time);
    EXPECT_NEAR(passed.time, std::clamp(time, 0.0, profile_.duration()), 0.02 * profile_.duration()) << i;
    const JointState there = profile_.at(passed.time);
    EXPECT_NEAR(passed.state.position, there.position, 1e-11) << i;
    EXPECT_NEAR(passed.state.velocity, there.velocity, 1e-10) << i;
  }
}

TEST_P(ProfileTest, NeverAcceleratesMoreThanItsLargestAcceleration) {
  const double h = 1e-4 * profile_.duration();
  double most = 0.0;
  for (double time = 0.0; time < profile_.duration(); time += h) {
    most = std::max(most, std::abs(profile_.at(time + h).velocity - profile_.at(time).velocity) / h);
  }
  EXPECT_LE(most, profile_.largest_acceleration() + 1e-5);
  EXPECT_GE(most, 0.2 * profile_.largest_acceleration());
}

TEST_P(ProfileTest, StatesAlongAnArcAreTheStatesAtTheirTimes) {
  for (const Arc& arc : profile_.arcs()) {
    const std::vector<JointState> states = profile_.states_along(arc, 30);
    ASSERT_EQ(states.size(), 31U);
    for (int i = 0; i <= 30; ++i) {
      const JointState expected = profile_.at(arc.start_time + (arc.end_time - arc.start_time) * i / 30.0);
      EXPECT_NEAR(states[i].position, expected.position, 1e-11);
      EXPECT_NEAR(states[i].velocity, expected.velocity, 1e-10);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(RisingAndFalling, ProfileTest,
                         testing::Values(std::pair{0.2, 1.5}, std::pair{1.5, 0.2}, std::pair{-2.0, 2.5},
                                         std::pair{0.5, 0.5001}));

TEST(Profile, FollowsTheExactMotionWhereItNearlyStalls) {
  // A little above the least torque that gets past (0.72461 G): an integration forwards in time loses the motion.
  const SingleJointArm system(pendulum(1.0, 1.0, 0.724611353776708 * (1.0 + 1e-7)));
  const Profile profile = std::get<FastestMotion>(fastest_motion(system, 0.0, 3.14159, Swings::kSkip)).profile;
  for (const Arc& arc : profile.arcs()) {
    const std::vector<JointState> states = profile.states_along(arc, 200);
    for (int i = 0; i < 200; ++i) {
      EXPECT_GE(states[i + 1].position, states[i].position);
      EXPECT_NEAR(profile.time_at(profile.legs().front(), states[i].position),
                  arc.start_time + (arc.end_time - arc.start_time) * i / 200.0, 1e-6);
    }
  }
}

TEST(Profile, ThatStandsStillIsAlwaysWhereItIs) {
  const SingleJointArm system(pendulum(1.0, 1.0, 2.0));
  const Profile still(system, 0.3);
  EXPECT_EQ(still.times_in({0.2, 0.4}).intervals(), (std::vector<Interval>{{-kInfinity, kInfinity}}));
  EXPECT_TRUE(still.times_in({0.4, 0.5}).empty());
  EXPECT_EQ(still.at(5.0).position, 0.3);
}

}  // namespace
}  // namespace dualarm
