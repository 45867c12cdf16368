#include "core/systems/playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "core/phase_plane/time_optimal.h"
#include "tests/core/phase_plane/test_arms.h"
#include "tests/core/systems/playback_check.h"

namespace dualarm {
namespace {

/// Strong limits of a kind: constant, a line, tables.
template <class Draw>
TorqueLimit drawn_limit(int kind, const Draw& draw) {
  if (kind == 0) return Interval{draw(-9.0, -4.0), draw(4.0, 9.0)};
  if (kind == 1) return TorqueSpeedLine{draw(4.0, 9.0), draw(1.5, 6.0)};
  const auto grid = [&](double at, double step) {
    std::vector<double> values = {at};
    for (int count = static_cast<int>(draw(0.0, 6.0)); count > 0; --count) {
      values.push_back(values.back() + draw(0.2, step));
    }
    return values;
  };
  TorqueTable table = {grid(draw(-6.0, 3.0), 3.0), grid(draw(-4.0, 1.0), 2.0), {}};
  while (table.limits.size() < table.positions.size() * table.velocities.size()) {
    table.limits.push_back({draw(-9.0, -4.2), draw(4.2, 9.0)});
  }
  return table;
}

/// Knots are finite and keep to the motion.
void expect_states_of(const Arm& arm, const SingleJointArm& system, const Profile& profile, double period) {
  const ArmTrajectory played = play(arm, system, {{0.0, profile}}, profile.duration(), period);
  for (const Knot& knot : played.knots) {
    const JointState exact = profile.at(knot.time);
    ASSERT_NEAR(knot.position, exact.position, 1e-9) << knot.time;
    ASSERT_NEAR(knot.velocity, exact.velocity, 1e-9) << knot.time;
  }
}

/// The quintics keep the limits but for the last digits of positions and times, even over the shortest pieces.
void expect_within_limits(const Arm& arm, const SingleJointArm& system, const Profile& profile, double period) {
  const ArmTrajectory played = play(arm, system, {{0.0, profile}}, profile.duration(), period);
  for (std::size_t i = 0; i + 1 < played.knots.size(); ++i) {
    const Knot& from = played.knots[i];
    const Knot& to = played.knots[i + 1];
    const double h = to.time - from.time;
    if (h < 1e-12) {
      ASSERT_NEAR(to.position, from.position, 1e-10);
      ASSERT_NEAR(to.velocity, from.velocity, 1e-10);
      continue;
    }
    if (h > 1e-3) continue;  // others test long pieces, where accelerations change
    const double acceleration = (to.velocity - from.velocity) / h;
    const double way = 0.5 * h * (from.velocity + to.velocity) + h * h / 12.0 * (from.acceleration - to.acceleration);
    const double last_digits = 4e-16 * (std::abs(to.position) + std::abs(to.velocity) * to.time);
    ASSERT_NEAR(to.position - from.position, way, last_digits + 1e-9 * h * h) << from.time;
    const JointState middle = {0.5 * (from.position + to.position), 0.5 * (from.velocity + to.velocity)};
    const Interval limits = system.acceleration(middle.position, middle.velocity);
    ASSERT_LE(acceleration, limits.upper + 1e-4) << from.time;
    ASSERT_GE(acceleration, limits.lower - 1e-4) << from.time;
  }
}

class Playback : public testing::Test {
 protected:
  Profile motion(JointState start, JointState goal) const {
    return std::get<FastestMotion>(fastest_motion(system_, start, goal)).profile;
  }
  Profile motion(double start, double goal) const { return motion(JointState{start, 0.0}, JointState{goal, 0.0}); }

  static Arm paper_arm() {
    Arm arm = pendulum(39.0, 29.43, 60.0);
    arm.velocity = {-1.2, 1.2};
    return arm;
  }

  Arm arm_ = paper_arm();
  SingleJointArm system_{arm_};
};

TEST_F(Playback, CoversThePlanFromItsBeginningToItsEnd) {
  const ArmTrajectory played = play(arm_, system_, {{0.5, motion(0.2, 1.4)}}, 4.0, 0.01);
  EXPECT_EQ(played.knots.front().time, 0.0);
  EXPECT_EQ(played.knots.back().time, 4.0);
  EXPECT_EQ(played.knots.back().position, 1.4);
  EXPECT_EQ(played.knots.back().acceleration, 0.0);
  EXPECT_EQ(played.start_time, 0.5);
  EXPECT_DOUBLE_EQ(played.duration, motion(0.2, 1.4).duration());
}

TEST_F(Playback, HoldsBeforeAndAfterTheMotion) {
  const ArmTrajectory played = play(arm_, system_, {{0.5, motion(0.2, 1.4)}}, 4.0, 0.01);
  EXPECT_EQ(played.arcs.front().kind, ArcKind::kHold);
  EXPECT_EQ(played.arcs.back().kind, ArcKind::kHold);
  for (std::size_t i = 0; i + 1 < played.arcs.size(); ++i) {
    EXPECT_EQ(played.arcs[i].end_time, played.arcs[i + 1].start_time);
    EXPECT_EQ(played.arcs[i].end, played.arcs[i + 1].start);
  }
}

TEST_F(Playback, ArrivesWithThePlanWhereOnlyRoundingIsLeftToWait) {
  const Profile profile = motion(0.5, 1.5);
  const double duration = profile.duration() + 5e-11;
  const ArmTrajectory played = play(arm_, system_, {{0.0, profile}}, duration, 0.05);
  EXPECT_EQ(played.arcs.back().kind, ArcKind::kBrake);
  EXPECT_EQ(played.arcs.back().end_time, duration);
  EXPECT_EQ(played.knots.back().time, duration);
  EXPECT_EQ(played.knots.back().position, 1.5);
  const ArmTrajectory waits = play(arm_, system_, {{0.0, profile}}, profile.duration() + 1e-9, 0.05);
  EXPECT_EQ(waits.arcs.back().kind, ArcKind::kHold);
}

TEST_F(Playback, KeepsTheKnotPeriodWhileItMoves) {
  const ArmTrajectory played = play(arm_, system_, {{0.0, motion(0.2, 1.4)}}, 3.0, 0.02);
  for (std::size_t i = 0; i + 1 < played.knots.size(); ++i) {
    if (played.knots[i + 1].time > played.duration + 1e-12) break;
    EXPECT_LE(played.knots[i + 1].time - played.knots[i].time, 0.02 + 1e-12);
  }
}

TEST_F(Playback, RefinesACoarsePeriodUntilTheQuinticIsFaithful) {
  const Profile profile = motion(0.2, 1.4);
  const ArmTrajectory played = play(arm_, system_, {{0.0, profile}}, profile.duration(), 10.0);
  for (std::size_t i = 0; i + 1 < played.knots.size(); ++i) {
    const Knot& from = played.knots[i];
    const Knot& to = played.knots[i + 1];
    if (to.time - from.time < 1e-9) continue;
    // Position of the quintic half way, against the exact motion.
    const double h = to.time - from.time;
    const double middle = 0.5 * (from.position + to.position) - 5.0 * h / 32.0 * (to.velocity - from.velocity) +
                          h * h / 64.0 * (from.acceleration + to.acceleration);
    EXPECT_NEAR(middle, profile.at(0.5 * (from.time + to.time)).position, 1e-10);
  }
}

TEST_F(Playback, JumpsInTorqueOnlyAtRepeatedTimes) {
  const ArmTrajectory played = play(arm_, system_, {{0.3, motion(1.4, 0.2)}}, 3.0, 0.01);
  for (std::size_t i = 0; i + 1 < played.knots.size(); ++i) {
    const Knot& from = played.knots[i];
    const Knot& to = played.knots[i + 1];
    EXPECT_DOUBLE_EQ(from.torque, system_.torque({from.position, 0.0}, from.acceleration));
    if (from.time == to.time) {
      EXPECT_EQ(from.position, to.position);
      EXPECT_EQ(from.velocity, to.velocity);
    } else {
      EXPECT_LT(std::abs(to.torque - from.torque), 3.0);
    }
  }
}

TEST_F(Playback, OfAnArmThatStandsStillIsAHold) {
  const ArmTrajectory played = play(arm_, system_, {{0.0, Profile(system_, 0.7)}}, 2.0, 0.01);
  ASSERT_EQ(played.arcs.size(), 1U);
  EXPECT_EQ(played.arcs[0].kind, ArcKind::kHold);
  EXPECT_EQ(played.duration, 0.0);
  EXPECT_DOUBLE_EQ(played.knots.front().torque, 29.43 * std::sin(0.7));
}

TEST_F(Playback, StringsMotionsTogetherWithRests) {
  const Profile there = motion(0.2, 1.0);
  const Profile back = motion(1.0, 0.4);
  const double second = there.duration() + 0.5;
  const ArmTrajectory played = play(arm_, system_, {{0.0, there}, {second, back}}, second + back.duration(), 0.01);
  EXPECT_EQ(played.knots.back().position, 0.4);
  EXPECT_DOUBLE_EQ(played.duration, second + back.duration());
}

TEST_F(Playback, BeginsWithAStartVelocity) {
  const ArmTrajectory played = play(arm_, system_, {{0.0, motion({0.2, 0.8}, {1.4, 0.0})}}, 4.0, 0.01);
  EXPECT_EQ(played.arcs.front().kind, ArcKind::kAccelerate);
  EXPECT_EQ(played.knots.front().time, 0.0);
  EXPECT_EQ(played.knots.front().position, 0.2);
  EXPECT_EQ(played.knots.front().velocity, 0.8);
  EXPECT_EQ(played.start_time, 0.0);
  EXPECT_EQ(played.arcs.back().kind, ArcKind::kHold);
}

TEST_F(Playback, EndsWithAGoalVelocity) {
  const Profile profile = motion({0.2, 0.0}, {1.4, 0.5});
  const double duration = 0.7 + profile.duration();
  const ArmTrajectory played = play(arm_, system_, {{0.7, profile}}, duration, 0.01);
  EXPECT_EQ(played.arcs.front().kind, ArcKind::kHold);
  EXPECT_EQ(played.arcs.back().kind, ArcKind::kBrake);
  EXPECT_EQ(played.arcs.back().end_time, duration);
  EXPECT_EQ(played.knots.back().time, duration);
  EXPECT_EQ(played.knots.back().position, 1.4);
  EXPECT_EQ(played.knots.back().velocity, 0.5);
  EXPECT_NEAR(played.knots.back().torque, -60.0, 1e-9);
}

TEST_F(Playback, EndsAMovingArmWithThePlanWhateverTheRounding) {
  const Profile profile = motion({0.2, 0.0}, {1.4, 0.5});
  for (const double rounding : {-1e-14, 1e-14}) {
    const double duration = profile.duration() + rounding;
    const ArmTrajectory played = play(arm_, system_, {{0.0, profile}}, duration, 0.01);
    EXPECT_EQ(played.knots.back().time, duration);
    EXPECT_EQ(played.arcs.back().end_time, duration);
  }
}

TEST_F(Playback, DoesNotLetAMovingArmWait) {
  const Profile moving_start = motion({0.2, 0.8}, {1.4, 0.0});
  const Profile moving_goal = motion({0.2, 0.0}, {1.4, 0.5});
  const Profile onwards = motion({1.4, 0.5}, {1.5, 0.0});
  EXPECT_THROW(play(arm_, system_, {{1e-6, moving_start}}, 4.0, 0.01), std::logic_error);
  EXPECT_THROW(play(arm_, system_, {{0.0, moving_goal}}, moving_goal.duration() + 1e-6, 0.01), std::logic_error);
  const double gap = moving_goal.duration() + 1e-6;
  EXPECT_THROW(play(arm_, system_, {{0.0, moving_goal}, {gap, onwards}}, 9.0, 0.01), std::logic_error);
}

TEST_F(Playback, StringsMotionsTogetherInFullMotion) {
  const Profile there = motion({0.2, 0.0}, {1.4, 0.5});
  const Profile onwards = motion({1.4, 0.5}, {1.0, 0.0});
  const double duration = there.duration() + onwards.duration();
  const ArmTrajectory played = play(arm_, system_, {{0.0, there}, {there.duration(), onwards}}, duration, 0.01);
  EXPECT_EQ(played.arcs.size(), there.arcs().size() + onwards.arcs().size());
  EXPECT_EQ(played.knots.back().position, 1.0);
  EXPECT_EQ(played.duration, duration);
}

TEST_F(Playback, OfNoDurationIsOneMovingInstant) {
  const ArmTrajectory played = play(arm_, system_, {{0.0, Profile(system_, JointState{0.3, 0.5})}}, 0.0, 0.01);
  ASSERT_EQ(played.knots.size(), 2U);
  for (const Knot& knot : played.knots) {
    EXPECT_EQ(knot.time, 0.0);
    EXPECT_EQ(knot.velocity, 0.5);
    EXPECT_EQ(knot.acceleration, 0.0);
  }
}

TEST_F(Playback, TurnsBackWithAKnotAtRest) {
  const Profile profile = motion({0.6, -0.9}, {1.0, 0.0});
  ASSERT_EQ(profile.legs().size(), 2U);
  const ArmTrajectory played = play(arm_, system_, {{0.0, profile}}, profile.duration(), 0.01);
  const auto turn = std::find_if(played.knots.begin(), played.knots.end(), [&](const Knot& knot) {
    return knot.position == profile.legs().front().goal && knot.velocity == 0.0;
  });
  ASSERT_NE(turn, played.knots.end());
  EXPECT_NEAR(turn->time, profile.legs().front().end_time, 1e-12);
  for (const Knot& knot : played.knots) EXPECT_GE(knot.position, turn->position);
}

TEST_F(Playback, StopsRefiningWhereItDoesNotHelp) {
  // An arc that ends a little faster than its torque allows: there are no knots that would make it true.
  const double speed = std::sqrt(2.0 * system_.specific_work(Extreme::kHighest, 0.2, 0.4));
  const Arc untrue = {ArcKind::kAccelerate, 0.0, 0.0, {0.2, 0.0}, {0.6, speed * (1.0 + 1e-7)}};
  const Profile profile(system_, {untrue});
  const ArmTrajectory played = play(arm_, system_, {{0.0, profile}}, profile.duration(), 0.01);
  EXPECT_LT(static_cast<double>(played.knots.size()), 3.0 * profile.duration() / 0.01);
}

TEST_F(Playback, FindsKnotsWhereTheFirstStepsRunAway) {
  // Steps of a tenth of this creeping motion are far beyond its drive's own time.
  Arm arm = pendulum(1.0, -0.9, 1.0);
  arm.viscous_friction = 3.0;
  arm.torque = TorqueSpeedLine{0.912, 0.3};
  const SingleJointArm system(arm);
  const auto found = fastest_motion(system, {2.175, 0.597}, {-0.843, 0.0});
  expect_states_of(arm, system, std::get<FastestMotion>(found).profile, 10.0);
}

TEST_F(Playback, ShowsNoRoundingInTheShortestArcs) {
  Arm arm = pendulum(1.0, 0.0, 1.0);
  arm.joint_range = {-7.0, 7.0};
  arm.torque = TorqueTable{{-1.0, 0.0, 1.0},
                           {-2.0, 1.5, 3.0},
                           {{-4, 6}, {-4, 5}, {-3, 6}, {-5, 3}, {-4, 4}, {-6, 2}, {-4, 2}, {-5, 5}, {-3, 3}}};
  const SingleJointArm system(arm);
  for (const double before : {1e-3, 1e-5, 1e-7, 1e-8, 1e-9, 3e-11}) {
    SCOPED_TRACE(before);
    for (const JointState start :
         {JointState{-before, 1.4}, JointState{0.7, 1.5 - before}, JointState{0.7, 1.5 + before}}) {
      const auto found = fastest_motion(system, start, {-0.8, 0.0});
      expect_within_limits(arm, system, std::get<FastestMotion>(found).profile, 0.01);
    }
  }
}

TEST_F(Playback, IsNotFooledByASymmetricArc) {
  // Half way of one quintic from end to end the exact acceleration is met, although the motion is not.
  Arm arm = pendulum(1.0, 1.0, 3.0);
  arm.torque = TorqueSpeedLine{3.0, 2.0};
  const SingleJointArm system(arm);
  const Arc through_the_bottom = {ArcKind::kAccelerate, 0.0, 0.0, {-1.0, 2.0}, {1.0, 2.0}};
  const Profile profile(system, {through_the_bottom});
  expect_faithful(arm, system, profile, 10.0);
}

/// Motions between any states under every kind of limit, from fixed seeds.
class PlaybackOfAnyMotion : public testing::TestWithParam<unsigned> {};

TEST_P(PlaybackOfAnyMotion, IsFaithfulAndSparing) {
  std::mt19937 random(GetParam());
  int moved = 0;
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    Arm arm = pendulum(draw(0.5, 4.0), draw(-4.0, 4.0), 1.0);
    arm.gravity.phase = draw(-3.0, 3.0);
    arm.joint_range = {-4.0, 5.0};
    arm.torque = drawn_limit(i % 4, draw);
    if (i % 3 == 0) arm.viscous_friction = draw(0.0, 2.0);
    if (i % 5 == 0) arm.velocity = {-draw(1.0, 3.0), draw(1.0, 3.0)};
    const SingleJointArm system(arm);
    const JointState start = {draw(-3.0, 4.0), i % 2 == 0 ? 0.0 : draw(-1.0, 1.0)};
    const JointState goal = {draw(-3.0, 4.0), i % 7 < 3 ? 0.0 : draw(-1.0, 1.0)};
    const auto found = fastest_motion(system, start, goal, Swings::kSkip);
    if (const auto* motion = std::get_if<FastestMotion>(&found)) {
      for (const double period : {0.01, 10.0}) expect_faithful(arm, system, motion->profile, period);
      ++moved;
    }
  }
  EXPECT_GT(moved, 30);
}

INSTANTIATE_TEST_SUITE_P(Seeds, PlaybackOfAnyMotion, testing::Range(1U, 9U));

}  // namespace
}  // namespace dualarm
