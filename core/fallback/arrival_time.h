#pragma once

#include <ompl/base/Goal.h>
#include <ompl/base/OptimizationObjective.h>

#include "core/fallback/steering.h"

namespace dualarm {

/// Both arms in given states, whenever that is.
class StateGoal final : public ompl::base::Goal {
 public:
  StateGoal(const ompl::base::SpaceInformationPtr& space, const JointStates& states) : Goal(space), states_(states) {}

  const JointStates& states() const { return states_; }
  bool isSatisfied(const ompl::base::State* state) const override;

 private:
  JointStates states_;
};

/// The cost of a path is the time (s) it ends at. Its cost-to-go is minimum_time to a StateGoal: exact for each arm
/// alone, never more than what both need.
class ArrivalTime final : public ompl::base::OptimizationObjective {
 public:
  explicit ArrivalTime(const ompl::base::SpaceInformationPtr& space);

  ompl::base::Cost stateCost(const ompl::base::State* state) const override;
  ompl::base::Cost motionCost(const ompl::base::State* from, const ompl::base::State* to) const override;
  ompl::base::Cost motionCostHeuristic(const ompl::base::State* from, const ompl::base::State* to) const override;
};

}  // namespace dualarm
