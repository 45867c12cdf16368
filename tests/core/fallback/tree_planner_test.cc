#include "core/fallback/tree_planner.h"

#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/geometric/PathGeometric.h>

#include "core/fallback/arrival_time.h"
#include "tests/core/fallback/search_space.h"

namespace dualarm {
namespace {

namespace ob = ompl::base;

const ob::PlannerTerminationCondition kNever([] { return false; });

class TreePlannerTest : public ::testing::Test {
 protected:
  void define(double first_goal, double second_goal) {
    definition_ = std::make_shared<ob::ProblemDefinition>(search_.information);
    definition_->addStartState(search_.state(10.0, 40.0, 0.0));
    const JointStates goal = at_rest({first_goal * kDegree, second_goal * kDegree});
    definition_->setGoal(std::make_shared<StateGoal>(search_.information, goal));
    definition_->setOptimizationObjective(std::make_shared<ArrivalTime>(search_.information));
  }

  std::unique_ptr<TreePlanner> planner(TreeLimits limits) {
    auto made = std::make_unique<TreePlanner>(search_.information, limits);
    made->setProblemDefinition(definition_);
    made->setup();
    return made;
  }

  SearchSpace search_{retreat_problem()};
  ob::ProblemDefinitionPtr definition_;
};

TEST_F(TreePlannerTest, FindsAnExactPathWhoseEveryEdgeIsProven) {
  define(40.0, 10.0);
  const auto tree = planner({3000, 500});
  ASSERT_EQ(tree->solve(kNever), ob::PlannerStatus::EXACT_SOLUTION);
  ASSERT_TRUE(definition_->hasExactSolution());
  const auto* path = definition_->getSolutionPath()->as<ompl::geometric::PathGeometric>();
  EXPECT_TRUE(search_.space->equalStates(path->getState(0), definition_->getStartState(0)));
  const auto last = static_cast<unsigned>(path->getStateCount()) - 1;
  for (unsigned i = 0; i < last; ++i) {
    EXPECT_TRUE(search_.information->isValid(path->getState(i)));
    EXPECT_TRUE(search_.information->checkMotion(path->getState(i), path->getState(i + 1)));
  }
  EXPECT_TRUE(definition_->getGoal()->isSatisfied(path->getState(last)));
}

TEST_F(TreePlannerTest, ReportsEachPlanWithItsArrivalAndTheBestFirst) {
  define(40.0, 10.0);
  const auto tree = planner({4000, 3000});
  ASSERT_EQ(tree->solve(kNever), ob::PlannerStatus::EXACT_SOLUTION);
  double previous = kRetreatBound;
  for (const ob::PlannerSolution& solution : definition_->getSolutions()) {
    EXPECT_TRUE(!solution.approximate_);
    EXPECT_NEAR(solution.length_, solution.cost_.value(), 1e-9);
    EXPECT_GE(solution.cost_.value(), previous);
    previous = solution.cost_.value();
  }
}

TEST_F(TreePlannerTest, ShootsStraightAtAGoalThatIsInTheOpen) {
  define(5.0, 90.0);
  const auto tree = planner({1000, 1000});
  ASSERT_EQ(tree->solve(kNever), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_EQ(tree->evaluations(), 1);  // the bound is reached: nothing is left to look for
}

TEST_F(TreePlannerTest, ReportsNothingForAGoalThatCannotBe) {
  define(30.0, 30.0);
  const auto tree = planner({800, 100});
  EXPECT_EQ(tree->solve(kNever), ob::PlannerStatus::TIMEOUT);
  EXPECT_FALSE(definition_->hasSolution());
  EXPECT_GE(tree->evaluations(), 800);
}

TEST_F(TreePlannerTest, GrowsNodesInMotion) {
  define(30.0, 30.0);
  const auto tree = planner({2000, 0});
  tree->solve(kNever);
  ob::PlannerData data(search_.information);
  tree->getPlannerData(data);
  int moving = 0;
  for (unsigned i = 0; i < data.numVertices(); ++i) {
    const JointStates states = StateTimeSpace::states(data.getVertex(i).getState());
    if (states[0].velocity != 0.0 || states[1].velocity != 0.0) ++moving;
  }
  EXPECT_GT(moving, 50);
}

TEST_F(TreePlannerTest, KeepsNoMoreNodesThanItMayAndGoesOn) {
  define(30.0, 30.0);
  TreeLimits limits{3000, 0};
  limits.nodes = 40;
  const auto tree = planner(limits);
  tree->solve(kNever);
  EXPECT_EQ(tree->most_nodes(), 40);
  EXPECT_GE(tree->evaluations(), 3000);
  define(40.0, 10.0);
  const auto second = planner(limits);
  EXPECT_EQ(second->solve(kNever), ob::PlannerStatus::EXACT_SOLUTION);
}

TEST_F(TreePlannerTest, LetsNoArmFirstMoveLaterThanItMay) {
  define(40.0, 10.0);
  TreeLimits limits{3000, 3000};
  limits.max_start_delay = 0.0;
  const auto tree = planner(limits);
  ASSERT_EQ(tree->solve(kNever), ob::PlannerStatus::EXACT_SOLUTION);
  for (int arm = 0; arm < kArmCount; ++arm) EXPECT_EQ(tree->best_edges().front().moves[arm].wait, 0.0);
}

TEST_F(TreePlannerTest, StartsAfreshOnceCleared) {
  define(40.0, 10.0);
  const auto tree = planner({3000, 500});
  tree->solve(kNever);
  const int evaluations = tree->evaluations();
  const double first = definition_->getSolutions().front().cost_.value();
  ob::PlannerData data(search_.information);
  tree->getPlannerData(data);
  EXPECT_GT(data.numVertices(), 2u);
  tree->clear();
  definition_->clearSolutionPaths();
  EXPECT_EQ(tree->evaluations(), 0);
  tree->solve(kNever);
  EXPECT_EQ(tree->evaluations(), evaluations);
  EXPECT_EQ(definition_->getSolutions().front().cost_.value(), first);
}

}  // namespace
}  // namespace dualarm
