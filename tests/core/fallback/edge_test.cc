#include "core/fallback/edge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/fallback/scenes.h"

namespace dualarm {
namespace {

/// Both arms out of each other's reach.
class EdgeTest : public ::testing::Test {
 protected:
  Attempt attempt(const JointStates& from, const JointStates& to) const {
    return Attempt(arms_.both(), proof_, from, 1.0, to);
  }

  Budget unlimited_;
  Problem problem_ = retreat_problem();
  ArmSystems arms_{problem_};
  ClearanceProof proof_{problem_, 1e-4, unlimited_};
  const JointStates rest_ = at_rest({1.5, 1.5});
};

TEST_F(EdgeTest, EndsWhereBothWereSent) {
  const Attempt both = attempt(rest_, at_rest({2.0, 2.5}));
  const double duration = std::max(both.duration(0), both.duration(1));
  const auto edge = both.edge({0.0, 0.0}, duration);
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->end, at_rest({2.0, 2.5}));
  EXPECT_EQ(edge->duration, duration);
}

TEST_F(EdgeTest, IsCutWhereTheFirstArmArrivesAndTheOtherOneIsInMotion) {
  const Attempt both = attempt(rest_, at_rest({1.8, 2.5}));
  ASSERT_LT(both.duration(0), both.duration(1));
  const auto edge = both.edge({0.0, 0.0}, both.duration(0));
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->end[0], (JointState{1.8, 0.0}));
  EXPECT_GT(edge->end[1].velocity, 0.1);
  const auto motions = motions_of(*arms_.both()[1], rest_[1], edge->moves[1]);
  ASSERT_TRUE(motions);
  EXPECT_NEAR(motions->back().duration(), both.duration(0), 1e-11);
  EXPECT_EQ(motions->back().goal_state(), edge->end[1]);
  const double rest_of_way = steering_time(*arms_.both()[1], edge->end[1], {2.5, 0.0});
  EXPECT_NEAR(motions->back().duration() + rest_of_way, both.duration(1), 1e-9);
}

TEST_F(EdgeTest, LetsNobodyWaitOrStayInMotion) {
  const JointStates moving = {JointState{1.5, 0.4}, JointState{1.5, 0.0}};
  const Attempt from_motion = attempt(moving, at_rest({2.0, 2.5}));
  ASSERT_TRUE(from_motion.is_possible());
  EXPECT_FALSE(from_motion.edge({0.1, 0.0}, 5.0));
  const Attempt to_motion = attempt(rest_, {JointState{2.0, 0.4}, JointState{2.5, 0.0}});
  ASSERT_TRUE(to_motion.is_possible());
  EXPECT_FALSE(to_motion.edge({0.0, 0.0}, to_motion.duration(0) + 1.0));
  EXPECT_TRUE(to_motion.edge({1.0, 0.0}, to_motion.duration(0) + 1.0));
}

TEST_F(EdgeTest, StretchesWhereAnArmCanNeitherWaitNorStay) {
  const JointStates from = {JointState{1.5, 0.4}, JointState{1.5, 0.0}};
  const JointStates to = {JointState{2.0, 0.4}, JointState{1.6, 0.0}};
  const double fastest = steering_time(*arms_.both()[0], from[0], to[0]);
  const auto edge = connect(arms_.both(), proof_, from, to, {0.0, fastest + 0.5});
  ASSERT_TRUE(edge);
  EXPECT_NEAR(edge->moves[0].lasts, fastest + 0.5, 1e-11);
  const auto motions = motions_of(*arms_.both()[0], from[0], edge->moves[0]);
  ASSERT_TRUE(motions);
  ASSERT_EQ(motions->size(), 2u);
  EXPECT_NEAR(motions->front().duration() + motions->back().duration(), fastest + 0.5, 1e-11);
  EXPECT_EQ(motions->back().goal_state(), to[0]);
}

TEST_F(EdgeTest, HasNoMotionWhereTheVelocityLimitForbidsIt) {
  EXPECT_FALSE(attempt(rest_, {JointState{2.0, 9.0}, JointState{1.5, 0.0}}).is_possible());
}

}  // namespace
}  // namespace dualarm
