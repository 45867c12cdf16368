#pragma once

#include <ompl/base/Goal.h>
#include <ompl/base/OptimizationObjective.h>

#include "core/fallback/steering.h"

namespace dualarm {

/// Both arms at rest at given positions (rad), not before a time (s): until then objects pass there, and arms that
/// arrive stay.
class RestGoal final : public ompl::base::Goal {
 public:
  RestGoal(const ompl::base::SpaceInformationPtr& space, const JointPair& positions, double not_before)
      : Goal(space), positions_(positions), not_before_(not_before) {}

  const JointPair& positions() const { return positions_; }
  double not_before() const { return not_before_; }
  bool isSatisfied(const ompl::base::State* state) const override;

 private:
  JointPair positions_;
  double not_before_;
};

/// The cost of a path is the time (s) it ends at. Its cost-to-go is minimum_time to a RestGoal: exact for each arm
/// alone, never more than what both need.
class ArrivalTime final : public ompl::base::OptimizationObjective {
 public:
  explicit ArrivalTime(const ompl::base::SpaceInformationPtr& space);

  ompl::base::Cost stateCost(const ompl::base::State* state) const override;
  ompl::base::Cost motionCost(const ompl::base::State* from, const ompl::base::State* to) const override;
  ompl::base::Cost motionCostHeuristic(const ompl::base::State* from, const ompl::base::State* to) const override;
};

}  // namespace dualarm
