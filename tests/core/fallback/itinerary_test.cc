#include "core/fallback/itinerary.h"

#include <gtest/gtest.h>

#include "tests/core/fallback/legs.h"
#include "tests/core/fallback/scenes.h"
#include "tests/core/fallback/schedule_check.h"

namespace dualarm {
namespace {

/// Arm 1 from 0.2 by way of 1.0 to 0.7 with a wait of 0.3 s there; arm 2 stands at 1.0.
class ItineraryTest : public ::testing::Test {
 protected:
  ItineraryTest() : problem_(retreat_problem()), arms_(problem_), itinerary_(arms_.both(), at_rest({0.2, 1.0})) {
    out_ = append_leg(itinerary_, arms_.both(), 0, 0.1, 0.2, 1.0);
    back_ = append_leg(itinerary_, arms_.both(), 0, 0.1 + out_ + 0.3, 1.0, 0.7);
  }

  Problem problem_;
  ArmSystems arms_;
  Itinerary itinerary_;
  double out_;
  double back_;
};

TEST_F(ItineraryTest, KeepsTheTimesItWasGiven) {
  EXPECT_EQ(itinerary_.leg_count(0), 2);
  EXPECT_EQ(itinerary_.leg_count(1), 0);
  EXPECT_NEAR(itinerary_.waits_between(), 0.3, 1e-12);
  EXPECT_NEAR(itinerary_.busy_time(0), out_ + 0.3 + back_, 1e-12);
  EXPECT_NEAR(itinerary_.duration(), 0.1 + out_ + 0.3 + back_, 1e-12);
  EXPECT_EQ(itinerary_.busy_time(1), 0.0);
}

TEST_F(ItineraryTest, SchedulesAMotionOfNoDurationForAnArmThatNeverMoves) {
  problem_.tasks = {Task{{0.2, 0.0}, {0.7, 0.0}}, Task{{1.0, 0.0}, {1.0, 0.0}}};
  expect_consistent(problem_, itinerary_.schedule(), itinerary_.duration());
  EXPECT_EQ(itinerary_.schedule()[1].size(), 1u);
}

TEST_F(ItineraryTest, TracksFollowTheSchedule) {
  const Schedule schedule = itinerary_.schedule();
  const std::array<Track, kArmCount> tracks = itinerary_.tracks();
  ASSERT_EQ(tracks[0].size(), 2u);
  ASSERT_EQ(tracks[1].size(), 1u);
  for (int leg = 0; leg < 2; ++leg) {
    EXPECT_NEAR(tracks[0][leg].start_time, schedule[0][leg].start_time, 1e-12);
    EXPECT_NEAR(tracks[0][leg].table->duration(), schedule[0][leg].profile.duration(), 1e-12);
  }
}

TEST_F(ItineraryTest, LeavesInTimeByASmallStepAndWaitsThere) {
  const double duration = itinerary_.duration();
  ASSERT_TRUE(itinerary_.leave_by(0, 0.02));
  EXPECT_EQ(itinerary_.leg_count(0), 3);
  EXPECT_EQ(itinerary_.first_start(0), 0.02);
  EXPECT_NEAR(itinerary_.goal(0, 0).position, 0.2, 2e-3);
  EXPECT_GT(itinerary_.goal(0, 0).position, 0.2);
  EXPECT_NEAR(itinerary_.duration(), duration, 1e-12);
  itinerary_.set_wait(0, 0, 0.07);
  ASSERT_TRUE(itinerary_.leave_by(0, 0.0));
  EXPECT_EQ(itinerary_.leg_count(0), 3) << "One small step is enough.";
  EXPECT_EQ(itinerary_.first_start(0), 0.0);
  EXPECT_NEAR(itinerary_.duration(), duration + 0.05, 1e-12);
  EXPECT_TRUE(itinerary_.leave_by(1, 0.0)) << "It never moves.";
}

TEST_F(ItineraryTest, MovesARestAndKeepsWhatItIsTold) {
  const double next_start = 0.1 + out_ + 0.3;
  const double arrival = next_start + back_;
  Itinerary moved = itinerary_;
  ASSERT_TRUE(moved.move_via(0, 0, {1.05, 0.0}, Keep::kWait));
  EXPECT_NEAR(moved.wait(0, 1), 0.3, 1e-12);
  EXPECT_EQ(moved.goal(0, 0).position, 1.05);
  moved = itinerary_;
  ASSERT_TRUE(moved.move_via(0, 0, {1.05, 0.0}, Keep::kNextStart));
  EXPECT_NEAR(moved.schedule()[0][1].start_time, next_start, 1e-12);
  moved = itinerary_;
  ASSERT_TRUE(moved.move_via(0, 0, {1.05, 0.0}, Keep::kNextArrival));
  EXPECT_NEAR(moved.duration(), arrival, 1e-12);
}

TEST_F(ItineraryTest, RefusesARestThatCannotBeReachedAndStaysAsItWas) {
  EXPECT_FALSE(itinerary_.move_via(0, 0, {9.0, 0.0}, Keep::kWait));
  EXPECT_FALSE(itinerary_.insert_via(0, 0, {9.0, 0.0}));
  EXPECT_EQ(itinerary_.leg_count(0), 2);
  EXPECT_EQ(itinerary_.goal(0, 0).position, 1.0);
}

TEST_F(ItineraryTest, DropsAndInsertsRests) {
  ASSERT_TRUE(itinerary_.drop_via(0, 0));
  EXPECT_EQ(itinerary_.leg_count(0), 1);
  EXPECT_NEAR(itinerary_.wait(0, 0), 0.4, 1e-12);
  EXPECT_EQ(itinerary_.goal(0, 0).position, 0.7);
  ASSERT_TRUE(itinerary_.insert_via(0, 0, {0.5, 0.0}));
  EXPECT_EQ(itinerary_.leg_count(0), 2);
  EXPECT_EQ(itinerary_.goal(0, 0).position, 0.5);
  EXPECT_EQ(itinerary_.wait(0, 1), 0.0);
}

TEST_F(ItineraryTest, PassesAStateInMotionWithoutAWait) {
  ASSERT_TRUE(itinerary_.move_via(0, 0, {0.9, 0.3}, Keep::kWait));
  EXPECT_FALSE(itinerary_.may_wait(0, 1));
  EXPECT_EQ(itinerary_.wait(0, 1), 0.0);
  itinerary_.set_wait(0, 1, 0.5);
  EXPECT_EQ(itinerary_.wait(0, 1), 0.0);
  problem_.tasks = {Task{{0.2, 0.0}, {0.7, 0.0}}, Task{{1.0, 0.0}, {1.0, 0.0}}};
  expect_consistent(problem_, itinerary_.schedule(), itinerary_.duration());
}

TEST_F(ItineraryTest, LetsAnArmInMotionAtItsGoalArriveAtTheEnd) {
  Itinerary resting(arms_.both(), at_rest({0.2, 1.0}));
  const JointState goal = {0.9, 0.5};
  const auto motion = steer(*arms_.both()[0], {0.2, 0.0}, goal);
  resting.append(0, 0.0, *motion, goal);
  ASSERT_TRUE(resting.settle(4.0));
  EXPECT_NEAR(resting.wait(0, 0), 4.0 - motion->duration(), 1e-12);
  EXPECT_FALSE(resting.settle(3.0)) << "too late for that";

  const JointState start = {0.2, 0.4};
  Itinerary moving(arms_.both(), {start, JointState{1.0, 0.0}});
  const auto quick = steer(*arms_.both()[0], start, goal);
  moving.append(0, 0.0, *quick, goal);
  ASSERT_TRUE(moving.settle(quick->duration() + 0.2));
  EXPECT_NEAR(moving.duration(), quick->duration() + 0.2, 1e-12);
  EXPECT_EQ(moving.leg_count(0), 2);
}

TEST_F(ItineraryTest, LetsAnArmStandOnlyAtRestOrInNoTime) {
  EXPECT_TRUE(Itinerary(arms_.both(), at_rest({0.2, 1.0})).settle(3.0));
  Itinerary moving(arms_.both(), {JointState{0.2, 0.4}, JointState{1.0, 0.0}});
  EXPECT_FALSE(moving.settle(3.0));
  EXPECT_TRUE(moving.settle(0.0));
}

TEST_F(ItineraryTest, StopsSlowingDownWhenItIsCancelled) {
  const JointState start = {0.2, 0.4};
  const JointState goal = {0.9, 0.5};
  Itinerary moving(arms_.both(), {start, JointState{1.0, 0.0}});
  const auto quick = steer(*arms_.both()[0], start, goal);
  moving.append(0, 0.0, *quick, goal);
  EXPECT_FALSE(moving.settle(quick->duration() + 0.2, Budget(Budget::Clock::now())));
}

TEST_F(ItineraryTest, LetsAnArmArriveNoSoonerThanAnObjectHasLeft) {
  Itinerary waiting(arms_.both(), at_rest({0.2, 1.0}), Arrivals{{3.0, 0.0}});
  append_leg(waiting, arms_.both(), 0, 0.0, 0.2, 0.7);
  ASSERT_TRUE(waiting.settle(3.0));
  EXPECT_NEAR(waiting.duration(), 3.0, 1e-12);
  Itinerary standing(arms_.both(), at_rest({0.2, 1.0}), Arrivals{{3.0, 0.0}});
  EXPECT_FALSE(standing.settle(3.0)) << "an arm that stands in an object's way";
}

TEST_F(ItineraryTest, AlignsOneArmToTheBeginningAndTheOtherToTheEnd) {
  append_leg(itinerary_, arms_.both(), 1, 0.2, 1.0, 0.5);
  itinerary_.align(0, 5.0);
  EXPECT_EQ(itinerary_.schedule()[0].front().start_time, 0.0);
  EXPECT_NEAR(itinerary_.schedule()[1].front().start_time, 5.0 - itinerary_.busy_time(1), 1e-12);
  EXPECT_NEAR(itinerary_.duration(), 5.0, 1e-12);
}

}  // namespace
}  // namespace dualarm
