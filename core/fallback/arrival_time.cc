#include "core/fallback/arrival_time.h"

#include "core/fallback/state_time_space.h"

namespace dualarm {

namespace ob = ompl::base;

bool StateGoal::isSatisfied(const ob::State* state) const { return StateTimeSpace::states(state) == states_; }

ArrivalTime::ArrivalTime(const ob::SpaceInformationPtr& space) : OptimizationObjective(space) {
  description_ = "Arrival time";
  const Systems systems = space->getStateSpace()->as<StateTimeSpace>()->systems();
  setCostToGoHeuristic([systems](const ob::State* state, const ob::Goal* goal) {
    return ob::Cost(
        minimum_time(systems, StateTimeSpace::states(state), static_cast<const StateGoal*>(goal)->states()));
  });
}

ob::Cost ArrivalTime::stateCost(const ob::State* /*state*/) const { return identityCost(); }

ob::Cost ArrivalTime::motionCost(const ob::State* from, const ob::State* to) const {
  return ob::Cost(si_->distance(from, to));
}

ob::Cost ArrivalTime::motionCostHeuristic(const ob::State* from, const ob::State* to) const {
  return ob::Cost(minimum_time(si_->getStateSpace()->as<StateTimeSpace>()->systems(), StateTimeSpace::states(from),
                               StateTimeSpace::states(to)));
}

}  // namespace dualarm
