#include "core/systems/playback.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/phase_plane/time_optimal.h"
#include "tests/core/phase_plane/test_arms.h"

namespace dualarm {
namespace {

class Playback : public testing::Test {
 protected:
  Profile motion(double start, double goal) const {
    return std::get<FastestMotion>(fastest_motion(system_, start, goal)).profile;
  }

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

}  // namespace
}  // namespace dualarm
