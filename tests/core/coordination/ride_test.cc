#include "core/coordination/ride.h"

#include <gtest/gtest.h>

#include "core/model/interval_set.h"
#include "tests/support/dice.h"

namespace dualarm {
namespace {

Eigen::Isometry3d any_pose(Dice& dice) {
  const auto number = [&](double bound) { return dice.between(-bound, bound); };
  const Eigen::Vector3d axis = Eigen::Vector3d(number(1.0), number(1.0), number(1.0)).normalized();
  return Eigen::Translation3d(number(6.0), number(6.0), number(1.0)) * Eigen::AngleAxisd(dice.between(0.0, 3.0), axis);
}

std::vector<Ride> rides_of(const Shape& shape, const PoseTrack& track) {
  std::vector<Ride> rides;
  for (std::size_t i = 0; i < track.segments().size(); ++i) {
    rides.emplace_back(shape, track.poses()[i], track.segments()[i]);
  }
  return rides;
}

PoseTrack any_track(Dice& dice, int poses) {
  std::vector<TimedPose> timed;
  for (int i = 0; i < poses; ++i) timed.push_back({0.5 * i, any_pose(dice)});
  return PoseTrack(timed);
}

TEST(RideTree, MeetsWhatItsRidesMeet) {
  constexpr int kSeed = 7;
  SCOPED_TRACE(kSeed);
  Dice dice(kSeed);
  const Shape link = Capsule{Eigen::Vector3d::Zero(), {4.0, 0.0, 0.0}, 0.1};
  int meetings = 0;
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE(trial);
    const Shape shape = Box{Eigen::Isometry3d::Identity(), {0.2, 0.1, 0.3}};
    const PoseTrack track = any_track(dice, 2 + trial);
    const std::vector<Ride> rides = rides_of(shape, track);
    std::vector<Interval> one_by_one;
    for (const Ride& ride : rides) {
      const auto times = colliding_parameters(link, ride, 0.05, ride.times());
      one_by_one.insert(one_by_one.end(), times.begin(), times.end());
    }
    std::vector<Interval> of_tree;
    RideTree(rides).add_meetings(link, 0.05, Budget(), of_tree);
    const IntervalSet expected(one_by_one);
    const IntervalSet found(of_tree);
    ASSERT_EQ(found.intervals().size(), expected.intervals().size());
    for (std::size_t i = 0; i < found.intervals().size(); ++i) {
      EXPECT_EQ(found.intervals()[i].lower, expected.intervals()[i].lower);
      EXPECT_EQ(found.intervals()[i].upper, expected.intervals()[i].upper);
      ++meetings;
    }
  }
  EXPECT_GT(meetings, 40);
}

TEST(RideTree, OfNoRidesMeetsNothing) {
  std::vector<Interval> times;
  RideTree({}).add_meetings(Capsule{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), 0.1}, 1.0, Budget(), times);
  EXPECT_TRUE(times.empty());
}

TEST(Ride, StaysInItsBall) {
  constexpr int kSeed = 8;
  SCOPED_TRACE(kSeed);
  Dice dice(kSeed);
  const Shape point_at_side = Capsule{{0.0, 0.7, 0.0}, {0.0, 0.7, 0.0}, 0.0};
  for (int trial = 0; trial < 50; ++trial) {
    const PoseTrack track = any_track(dice, 2);
    const Ride ride = rides_of(point_at_side, track).front();
    const Ball ball = ride.ball();
    for (double time = 0.0; time <= 0.5; time += 0.01) {
      const Shape there = ride.shape_at(time);
      EXPECT_LE((std::get<Capsule>(there).start - ball.middle).norm(), ball.radius + 1e-12);
    }
  }
}

}  // namespace
}  // namespace dualarm
