#include "geometry/lens.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr Interval kHalfTurn = {0.0, kPi};

Segment turned(const Segment& segment, double angle) {
  const Eigen::Rotation2Dd turn(angle);
  return {turn * segment.start, turn * segment.end};
}

/// Arm 1 of the paper (l = 6) in the mirrored frame of arm 2, whose base is 8 m away.
Segment paper_arm_seen_by_second(double theta1) {
  return {{8.0, 0.0}, {8.0 - 6.0 * std::cos(theta1), 6.0 * std::sin(theta1)}};
}

const Segment kPaperLink = {{0.0, 0.0}, {6.0, 0.0}};

/// [theory, section 2] the true set of two segments: theta2 below the elevation of tip 1 and arm 2's tip beyond arm 1.
bool in_paper_lens(double theta1, double theta2) {
  return theta2 <= std::atan2(6.0 * std::sin(theta1), 8.0 - 6.0 * std::cos(theta1)) &&
         8.0 * std::sin(theta1) <= 6.0 * std::sin(theta1 + theta2);
}

TEST(SegmentDistance, IsZeroWhereSegmentsCrossAndTheGapElsewhere) {
  EXPECT_EQ(segment_distance({{-1, 0}, {1, 0}}, {{0, -1}, {0, 1}}), 0.0);
  EXPECT_DOUBLE_EQ(segment_distance({{0, 0}, {1, 0}}, {{0, 2}, {1, 2}}), 2.0);
  EXPECT_DOUBLE_EQ(segment_distance({{0, 0}, {1, 0}}, {{4, 4}, {4, 4}}), 5.0);
}

TEST(CollidingAngles, AreTheClosedFormLensOfTwoSegmentArms) {
  for (double theta1 = 0.01; theta1 < 1.2; theta1 += 0.01) {
    const auto slice = colliding_angles(paper_arm_seen_by_second(theta1), kPaperLink, 0.0, kHalfTurn);
    for (double theta2 = 0.003; theta2 < 1.5; theta2 += 0.01) {
      const bool inside = !slice.empty() && slice.front().contains(theta2);
      ASSERT_EQ(inside, in_paper_lens(theta1, theta2)) << theta1 << " " << theta2;
    }
  }
}

TEST(CollidingAngles, HaveTheirCornerAtTheTipPointWhereBothTipsMeet) {
  const double tip = std::acos(2.0 / 3.0);
  const auto slice = colliding_angles(paper_arm_seen_by_second(tip), kPaperLink, 0.0, kHalfTurn);
  ASSERT_EQ(slice.size(), 1U);
  EXPECT_NEAR(slice.front().upper, tip, 1e-12);
  EXPECT_NEAR(slice.front().lower, std::asin(8.0 * std::sin(tip) / 6.0) - tip, 1e-12);
}

TEST(CollidingAngles, AreNoneOnceArmOneStandsClearOfArmTwosReach) {
  const double farthest = std::asin(6.0 / 8.0);  // L sin(theta1) = l2
  EXPECT_TRUE(colliding_angles(paper_arm_seen_by_second(farthest + 1e-9), kPaperLink, 0.0, kHalfTurn).empty());
  EXPECT_FALSE(colliding_angles(paper_arm_seen_by_second(farthest - 1e-9), kPaperLink, 0.0, kHalfTurn).empty());
}

TEST(CollidingAngles, HaveBothEndsAtTheAskedDistance) {
  const auto slice = colliding_angles(paper_arm_seen_by_second(0.4), kPaperLink, 0.3, {-kPi, kPi});
  ASSERT_EQ(slice.size(), 1U);
  for (const double angle : {slice.front().lower, slice.front().upper}) {
    EXPECT_NEAR(segment_distance(paper_arm_seen_by_second(0.4), turned(kPaperLink, angle)), 0.3, 1e-12);
  }
}

TEST(CollidingAngles, RepeatEveryTurnOfTheWindow) {
  const Segment point = {{5.0, 0.0}, {5.0, 0.0}};
  const auto slice = colliding_angles(point, kPaperLink, 0.5, {-kPi, 5.0 * kPi});
  ASSERT_EQ(slice.size(), 3U);
  for (int turn = 0; turn < 3; ++turn) {
    EXPECT_NEAR(0.5 * (slice[turn].lower + slice[turn].upper), 2.0 * kPi * turn, 1e-12);
  }
}

TEST(CollidingAngles, CoverTheWholeWindowWhereTheJointItselfIsHit) {
  const auto slice = colliding_angles({{0.1, 0.0}, {4.0, 0.0}}, kPaperLink, 0.2, {-1.0, 2.0});
  ASSERT_EQ(slice.size(), 1U);
  EXPECT_EQ(slice.front(), (Interval{-1.0, 2.0}));
}

TEST(CollidingAngles, AgreeWithTheDistanceOnRandomSegments) {
  constexpr unsigned kSeed = 20261122;
  SCOPED_TRACE(kSeed);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> coordinate(-3.0, 3.0);
  std::uniform_real_distribution<double> gap(0.0, 1.0);
  for (int scene = 0; scene < 3000; ++scene) {
    const auto point = [&] { return Eigen::Vector2d(coordinate(random), coordinate(random)); };
    const Segment fixed = {point(), scene % 7 == 0 ? Eigen::Vector2d(1.0, 0.5) : point()};
    const Segment turning = {scene % 2 == 0 ? Eigen::Vector2d(0.0, 0.0) : point(), point()};
    const double distance = gap(random);
    const Interval window = {-kPi, kPi};
    const auto slice = colliding_angles(fixed, turning, distance, window);
    for (double angle = -kPi; angle <= kPi; angle += 0.02) {
      const double excess = segment_distance(fixed, turned(turning, angle)) - distance;
      if (std::abs(excess) < 1e-9) continue;
      bool inside = false;
      for (const Interval& piece : slice) inside = inside || piece.contains(angle);
      ASSERT_EQ(inside, excess < 0.0) << "scene " << scene << " angle " << angle << " excess " << excess;
    }
  }
}

}  // namespace
}  // namespace dualarm
