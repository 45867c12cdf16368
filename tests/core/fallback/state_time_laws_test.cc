#include <gtest/gtest.h>

#include <cmath>

#include "core/fallback/arrival_time.h"
#include "core/fallback/random.h"
#include "core/fallback/sampler.h"
#include "tests/core/fallback/search_space.h"

// What holds for every state, pair and triple of states of the search, on samples from fixed seeds.

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-9;  // s, of times of motions of some seconds

/// A drive that is strong, one that fades with speed and rubs, and one with limits of different size.
std::vector<Problem> drives() {
  std::vector<Problem> problems(3, retreat_problem());
  for (int arm = 0; arm < kArmCount; ++arm) {
    problems[1].arms[arm].torque = TorqueSpeedLine{70.0, 3.0};
    problems[2].arms[arm].torque = Interval{-45.0, 80.0};
    problems[2].arms[arm].velocity = {-1.0, 2.5};
  }
  return problems;
}

class StateTimeLaws : public ::testing::TestWithParam<int> {
 protected:
  JointStates draw() {
    sampler_->sampleUniform(state_.get());
    return StateTimeSpace::states(state_.get());
  }

  SearchSpace search_{drives()[GetParam()], 1e-4, 11};
  const Systems& systems_ = search_.arms.both();
  std::shared_ptr<Sampler> sampler_ = std::static_pointer_cast<Sampler>(search_.space->allocStateSampler());
  ompl::base::ScopedState<StateTimeSpace> state_{search_.information};
};

TEST_P(StateTimeLaws, DistanceIsTimeForwardsAndNothingBackwards) {
  int reached = 0;
  for (int i = 0; i < 600; ++i) {
    const JointStates from = draw();
    const JointStates to = draw();
    const double needed = steering_time(systems_, from, to);
    const auto here = search_.state(from, 1.0);
    EXPECT_EQ(search_.space->distance(search_.state(to, 1.0 + 1e-3).get(), here.get()), kInfinity);
    if (std::isinf(needed)) continue;
    ++reached;
    EXPECT_NEAR(search_.space->distance(here.get(), search_.state(to, 1.0 + needed + 0.5).get()), needed + 0.5, 1e-12);
    EXPECT_EQ(search_.space->distance(here.get(), search_.state(to, 1.0 + 0.99 * needed).get()), kInfinity);
  }
  EXPECT_GT(reached, 150);
}

TEST_P(StateTimeLaws, CostToGoIsNeverMoreThanWhatSteeringTakes) {
  int compared = 0;
  for (int i = 0; i < 600; ++i) {
    const JointStates from = draw();
    const JointStates to = draw();
    const double needed = steering_time(systems_, from, to);
    EXPECT_LE(minimum_time(systems_, from, to), needed + kRounding);
    compared += std::isfinite(needed) ? 1 : 0;
  }
  EXPECT_GT(compared, 150);
}

TEST_P(StateTimeLaws, CostToGoIsNeverMoreThanToGoAnywhereFirst) {
  int compared = 0;
  for (int i = 0; i < 1500; ++i) {
    const JointStates from = draw();
    const JointStates by = draw();
    const JointStates to = draw();
    const double way = steering_time(systems_, from, by) + steering_time(systems_, by, to);
    if (std::isinf(way)) continue;
    ++compared;
    EXPECT_LE(minimum_time(systems_, from, to), way + kRounding);
  }
  EXPECT_GT(compared, 100);
}

TEST_P(StateTimeLaws, CostToGoFallsByTheTimeThatPassesOnTheFastestMotion) {
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    const JointState from = draw()[0];
    const JointState to = draw()[0];
    const auto motion = steer(*systems_[0], from, to);
    if (!motion || motion->duration() < 0.2) continue;
    const double time = 0.4 * motion->duration();
    const auto part = cut(*systems_[0], *motion, time);
    if (!part) continue;
    ++compared;
    EXPECT_NEAR(steering_time(*systems_[0], part->goal_state(), to), motion->duration() - time, 1e-6);
  }
  EXPECT_GT(compared, 50);
}

TEST_P(StateTimeLaws, AnEdgeIsProvenOrNotWheneverItBeginsWhereNothingMovesByItself) {
  int valid = 0;
  int invalid = 0;
  for (int i = 0; i < 300; ++i) {
    const JointStates from = draw();
    const JointStates to = draw();
    const double needed = steering_time(systems_, from, to);
    if (std::isinf(needed)) continue;
    const double duration = needed + 0.25;
    const auto check = [&](double time) {
      const auto here = search_.state(from, time);
      return search_.information->checkMotion(here.get(), search_.state(to, time + duration).get());
    };
    const bool at_once = check(0.0);
    EXPECT_EQ(check(4.0), at_once);
    ++(at_once ? valid : invalid);
  }
  EXPECT_GT(valid, 20);
  EXPECT_GT(invalid, 20);
}

TEST_P(StateTimeLaws, AnEdgeLeadsToTheStateItWasAskedForInTheTimeItWasGiven) {
  for (int i = 0; i < 300; ++i) {
    const JointStates from = draw();
    const JointStates to = draw();
    const double needed = steering_time(systems_, from, to);
    if (std::isinf(needed)) continue;
    const auto edge = connect(systems_, search_.proof, from, to, {2.0, 2.25 + needed});
    if (!edge) continue;
    EXPECT_EQ(edge->end, to);
    EXPECT_NEAR(edge->duration, needed + 0.25, 1e-12);
    for (int arm = 0; arm < kArmCount; ++arm) {
      const Move& move = edge->moves[arm];
      EXPECT_GE(move.wait, 0.0);
      EXPECT_LE(move.wait + move.lasts, edge->duration + 1e-10);
      if (from[arm].velocity != 0.0) {
        EXPECT_EQ(move.wait, 0.0);
      }
      if (to[arm].velocity != 0.0) {
        EXPECT_NEAR(move.wait + move.lasts, edge->duration, 1e-10);
      }
    }
  }
}

TEST_P(StateTimeLaws, ArrivalTimeAddsUpAlongAPathAndItsHeuristicsAreNoLarger) {
  const ArrivalTime objective(search_.information);
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    const JointStates states = draw();
    const JointStates goal = draw();
    const double needed = steering_time(systems_, states, goal);
    if (std::isinf(needed)) continue;
    ++compared;
    const auto here = search_.state(states, 1.5);
    const auto there = search_.state(goal, 1.5 + needed);
    const double cost = objective.motionCost(here.get(), there.get()).value();
    EXPECT_NEAR(cost, needed, 1e-12);
    EXPECT_LE(objective.motionCostHeuristic(here.get(), there.get()).value(), cost + kRounding);
    const StateGoal wanted(search_.information, goal);
    EXPECT_LE(objective.costToGo(here.get(), &wanted).value(), cost + kRounding);
    EXPECT_TRUE(wanted.isSatisfied(there.get()));
  }
  EXPECT_GT(compared, 80);
}

TEST_P(StateTimeLaws, DifferenceIsAMetric) {
  for (int i = 0; i < 300; ++i) {
    const JointStates a = draw();
    const JointStates b = draw();
    const JointStates c = draw();
    const auto difference = [this](const JointStates& from, const JointStates& to) {
      return search_.space->difference(from, to);
    };
    EXPECT_EQ(difference(a, a), 0.0);
    EXPECT_EQ(difference(a, b), difference(b, a));
    EXPECT_LE(difference(a, c), difference(a, b) + difference(b, c) + 1e-12);
  }
}

TEST_P(StateTimeLaws, SamplesLieInBoundsAlsoOfAHorizonThatShrank) {
  search_.space->shrink(3.0);
  search_.space->shrink(8.0);
  EXPECT_EQ(search_.space->getMaximumExtent(), 3.0);
  for (int i = 0; i < 300; ++i) {
    draw();
    EXPECT_TRUE(search_.space->satisfiesBounds(state_.get()));
    EXPECT_LE(StateTimeSpace::time(state_.get()), 3.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Drives, StateTimeLaws, ::testing::Range(0, 3));

}  // namespace
}  // namespace dualarm
