#include "core/fallback/arrival_time.h"

#include "core/fallback/state_time_space.h"

namespace dualarm {

namespace ob = ompl::base;

bool RestGoal::isSatisfied(const ob::State* state) const { return StateTimeSpace::positions(state) == positions_; }

ArrivalTime::ArrivalTime(const ob::SpaceInformationPtr& space) : OptimizationObjective(space) {
  description_ = "Arrival time";
  const Systems systems = space->getStateSpace()->as<StateTimeSpace>()->systems();
  setCostToGoHeuristic([systems](const ob::State* state, const ob::Goal* goal) {
    return ob::Cost(
        minimum_time(systems, StateTimeSpace::positions(state), static_cast<const RestGoal*>(goal)->positions()));
  });
}

ob::Cost ArrivalTime::stateCost(const ob::State* /*state*/) const { return identityCost(); }

ob::Cost ArrivalTime::motionCost(const ob::State* from, const ob::State* to) const {
  return ob::Cost(si_->distance(from, to));
}

ob::Cost ArrivalTime::motionCostHeuristic(const ob::State* from, const ob::State* to) const {
  return ob::Cost(minimum_time(si_->getStateSpace()->as<StateTimeSpace>()->systems(), StateTimeSpace::positions(from),
                               StateTimeSpace::positions(to)));
}

}  // namespace dualarm
