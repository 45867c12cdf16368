#include "core/model/pose_track.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/dice.h"

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint64_t kSeed = 61;

Eigen::Isometry3d pose_of(const Eigen::Vector3d& at, double angle, const Eigen::Vector3d& axis) {
  return Eigen::Translation3d(at) * Eigen::AngleAxisd(angle, axis);
}

/// A metre along x in 2 s with a quarter turn about z, then back up in 1 s without turning.
PoseTrack bent_track() {
  return PoseTrack({{1.0, pose_of({0.0, 0.0, 0.0}, 0.0, Eigen::Vector3d::UnitZ())},
                    {3.0, pose_of({1.0, 0.0, 0.0}, 0.5 * kPi, Eigen::Vector3d::UnitZ())},
                    {4.0, pose_of({1.0, 0.0, 3.0}, 0.5 * kPi, Eigen::Vector3d::UnitZ())}});
}

PoseTrack random_track(Dice& dice) {
  const auto vector = [&] {
    return Eigen::Vector3d(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
  };
  std::vector<TimedPose> poses;
  double time = dice.between(-1.0, 1.0);
  const int count = 1 + dice.one_of(5);
  for (int i = 0; i < count; ++i) {
    poses.push_back({time, pose_of(vector(), dice.between(0.0, kPi), vector().normalized())});
    time += dice.happens(0.3) ? 1e-3 : dice.between(0.1, 2.0);
  }
  return PoseTrack(poses);
}

TEST(PoseTrack, StandsAtTheOriginUnlessToldOtherwise) {
  const PoseTrack track;
  EXPECT_TRUE(track.pose_at(-3.0).isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_TRUE(track.pose_at(7.0).isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_EQ(track.travel({-1.0, 9.0}), 0.0);
  EXPECT_EQ(track.turn({-1.0, 9.0}), 0.0);
  EXPECT_EQ(track.largest_speed({-1.0, 9.0}), 0.0);
}

TEST(PoseTrack, MovesStraightAndTurnsEvenlyBetweenItsPoses) {
  const PoseTrack track = bent_track();
  EXPECT_TRUE(track.pose_at(1.5).isApprox(pose_of({0.25, 0.0, 0.0}, 0.125 * kPi, Eigen::Vector3d::UnitZ()), 1e-14));
  EXPECT_TRUE(track.pose_at(3.5).isApprox(pose_of({1.0, 0.0, 1.5}, 0.5 * kPi, Eigen::Vector3d::UnitZ()), 1e-14));
  for (const TimedPose& given : track.poses()) EXPECT_TRUE(track.pose_at(given.time).isApprox(given.pose, 1e-14));
}

TEST(PoseTrack, HoldsBeforeItsFirstPoseAndAfterItsLast) {
  const PoseTrack track = bent_track();
  EXPECT_TRUE(track.pose_at(-5.0).isApprox(track.poses().front().pose));
  EXPECT_TRUE(track.pose_at(99.0).isApprox(track.poses().back().pose));
  EXPECT_EQ(track.travel({-5.0, 1.0}), 0.0);
  EXPECT_EQ(track.turn({4.0, 99.0}), 0.0);
  EXPECT_EQ(track.largest_speed({4.5, 99.0}), 0.0);
  EXPECT_EQ(track.largest_turning_rate({-5.0, 0.5}), 0.0);
  EXPECT_EQ(track.begin_time(), 1.0);
  EXPECT_EQ(track.end_time(), 4.0);
}

TEST(PoseTrack, AddsUpWhatItTravelsAndTurnsThroughBendsAndBack) {
  const PoseTrack track = bent_track();
  EXPECT_NEAR(track.travel({0.0, 9.0}), 4.0, 1e-14);
  EXPECT_NEAR(track.travel({2.0, 3.5}), 0.5 + 1.5, 1e-14);
  EXPECT_NEAR(track.turn({0.0, 9.0}), 0.5 * kPi, 1e-14);
  EXPECT_NEAR(track.turn({2.0, 3.5}), 0.25 * kPi, 1e-14);
  const PoseTrack there_and_back({{0.0, pose_of({0, 0, 0}, 0.0, Eigen::Vector3d::UnitX())},
                                  {1.0, pose_of({2, 0, 0}, 1.0, Eigen::Vector3d::UnitX())},
                                  {2.0, pose_of({0, 0, 0}, 0.0, Eigen::Vector3d::UnitX())}});
  EXPECT_NEAR(there_and_back.travel({0.0, 2.0}), 4.0, 1e-14);
  EXPECT_NEAR(there_and_back.turn({0.0, 2.0}), 2.0, 1e-14);
}

TEST(PoseTrack, TakesTheLargestRateOfEveryPieceAnIntervalTouches) {
  const PoseTrack track = bent_track();
  EXPECT_DOUBLE_EQ(track.largest_speed({1.5, 2.5}), 0.5);
  EXPECT_DOUBLE_EQ(track.largest_speed({3.2, 3.3}), 3.0);
  EXPECT_DOUBLE_EQ(track.largest_speed({0.0, 9.0}), 3.0);
  EXPECT_DOUBLE_EQ(track.largest_speed({3.0, 3.0}), 3.0) << "at a corner that of both sides counts";
  EXPECT_DOUBLE_EQ(track.largest_turning_rate({3.0, 3.0}), 0.25 * kPi);
  EXPECT_DOUBLE_EQ(track.largest_turning_rate({3.5, 9.0}), 0.0);
}

TEST(PoseTrack, TurnsTheShorterWayRound) {
  const PoseTrack track({{0.0, pose_of({0, 0, 0}, 0.0, Eigen::Vector3d::UnitZ())},
                         {1.0, pose_of({0, 0, 0}, 1.5 * kPi, Eigen::Vector3d::UnitZ())}});
  EXPECT_NEAR(track.turn({0.0, 1.0}), 0.5 * kPi, 1e-14);
  EXPECT_TRUE(track.pose_at(0.5).isApprox(pose_of({0, 0, 0}, -0.25 * kPi, Eigen::Vector3d::UnitZ()), 1e-14));
}

TEST(PoseTrack, NoPointMovesByMoreThanTravelAndExtentTimesTurnNorFasterThanItsRates) {
  SCOPED_TRACE(kSeed);
  Dice dice(kSeed);
  double largest_use = 0.0;
  for (int i = 0; i < 20000; ++i) {
    SCOPED_TRACE(i);
    const PoseTrack track = random_track(dice);
    const Eigen::Vector3d point(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
    const double from = dice.between(-2.0, 6.0);
    const Interval time = {from, from + dice.between(0.0, 1.0) * dice.between(0.0, 3.0)};
    const double moved = (track.pose_at(time.upper) * point - track.pose_at(time.lower) * point).norm();
    const double allowed = track.travel(time) + point.norm() * track.turn(time);
    ASSERT_LE(moved, allowed + 1e-12);
    const double fastest = track.largest_speed(time) + point.norm() * track.largest_turning_rate(time);
    ASSERT_LE(moved, fastest * time.length() + 1e-12);
    if (allowed > 1e-6) largest_use = std::max(largest_use, moved / allowed);
  }
  EXPECT_GT(largest_use, 0.9);
}

TEST(PoseTrack, IsContinuousAndAlwaysAnIsometry) {
  SCOPED_TRACE(kSeed);
  Dice dice(kSeed);
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const PoseTrack track = random_track(dice);
    for (const TimedPose& given : track.poses()) {
      for (const double side : {-1e-12, 1e-12}) {
        ASSERT_TRUE(track.pose_at(given.time + side).isApprox(given.pose, 1e-7));
      }
    }
    const Eigen::Matrix3d turn = track.pose_at(dice.between(-1.0, 5.0)).linear();
    ASSERT_LE((turn.transpose() * turn - Eigen::Matrix3d::Identity()).norm(), 1e-13);
  }
}

}  // namespace
}  // namespace dualarm
