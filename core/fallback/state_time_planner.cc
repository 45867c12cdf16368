#include "core/fallback/state_time_planner.h"

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/fallback/arrival_time.h"
#include "core/fallback/motion_validator.h"
#include "core/fallback/random.h"
#include "core/fallback/refine.h"
#include "core/fallback/state_time_space.h"
#include "core/fallback/tree_planner.h"

namespace dualarm {
namespace {

namespace ob = ompl::base;

/// Part of the evaluations that the tree may use once it has a plan; until then it may use all.
constexpr double kTreeShareAfterFirstPlan = 0.1;

/// The space's time bound, in multiples of the arms' ways across their whole ranges; only bounds what OMPL samples.
constexpr double kHorizonFactor = 10.0;

/// s, where no such way exists.
constexpr double kHorizonWithoutWay = 1e3;

/// Sets the refinement's chances apart from the tree's.
constexpr std::uint64_t kRefinementSeed = 0x9e3779b97f4a7c15;

double horizon(const Systems& systems) {
  const Interval first = systems[0]->range();
  const Interval second = systems[1]->range();
  const double way = std::max(monotone_time(systems, {first.lower, second.lower}, {first.upper, second.upper}),
                              monotone_time(systems, {first.upper, second.upper}, {first.lower, second.lower}));
  return std::isfinite(way) && way > 0.0 ? kHorizonFactor * way : kHorizonWithoutWay;
}

/// The tree's path as an itinerary. Edges follow from their ends, so the path's states are all it takes.
Itinerary itinerary_along(const Systems& systems, const ClearanceProof& proof,
                          const ompl::geometric::PathGeometric& path) {
  Itinerary itinerary(systems, StateTimeSpace::positions(path.getState(0)));
  for (unsigned i = 0; i + 1 < path.getStateCount(); ++i) {
    const JointPair from = StateTimeSpace::positions(path.getState(i));
    const JointPair to = StateTimeSpace::positions(path.getState(i + 1));
    const double begin = StateTimeSpace::time(path.getState(i));
    const auto edge = connect(systems, proof, from, to, {begin, StateTimeSpace::time(path.getState(i + 1))});
    for (int arm = 0; arm < kArmCount; ++arm) {
      itinerary.append(arm, begin + edge.value().motions[arm].start_time, to[arm]);
    }
  }
  return itinerary;
}

}  // namespace

SearchResult search_state_time(const Problem& problem, const Systems& systems, double clearance, double earliest_end,
                               int evaluation_limit, const Budget& budget) {
  const ClearanceProof proof(problem, clearance);
  const std::uint64_t seed = problem.options.seed;
  const JointPair start = {problem.tasks[0].start.position, problem.tasks[1].start.position};
  const JointPair goal = {problem.tasks[0].goal.position, problem.tasks[1].goal.position};

  auto space = std::make_shared<StateTimeSpace>(systems, horizon(systems), seed, proof.settled_time());
  auto information = std::make_shared<ob::SpaceInformation>(space);
  information->setStateValidityChecker(std::make_shared<RestValidity>(information, proof));
  information->setMotionValidator(std::make_shared<EdgeValidator>(information, proof));
  information->setup();

  auto definition = std::make_shared<ob::ProblemDefinition>(information);
  ob::ScopedState<StateTimeSpace> start_state(information);
  StateTimeSpace::set(start_state.get(), start, 0.0);
  definition->addStartState(start_state);
  definition->setGoal(std::make_shared<RestGoal>(information, goal, earliest_end));
  definition->setOptimizationObjective(std::make_shared<ArrivalTime>(information));

  TreePlanner tree(information, {evaluation_limit, static_cast<int>(kTreeShareAfterFirstPlan * evaluation_limit)});
  tree.setProblemDefinition(definition);
  tree.setup();
  const bool solved = tree.solve(ob::PlannerTerminationCondition([&budget] { return budget.exhausted(); })) ==
                      ob::PlannerStatus::EXACT_SOLUTION;
  SearchResult result;
  result.evaluation_count = tree.evaluations();
  if (solved) {
    const auto* path = definition->getSolutionPath()->as<ompl::geometric::PathGeometric>();
    Random random(seed ^ kRefinementSeed);
    const double lower_bound = std::max(earliest_end, minimum_time(systems, start, goal));
    Refinement refinement(systems, proof, itinerary_along(systems, proof, *path), lower_bound, random, budget);
    refinement.run(evaluation_limit - result.evaluation_count);
    result.evaluation_count += refinement.evaluations();
    result.schedule = refinement.best().schedule();
    result.duration = refinement.best().duration();
  }
  result.budget_ran_out = budget.exhausted();
  return result;
}

}  // namespace dualarm
