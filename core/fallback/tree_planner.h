#pragma once

#include <ompl/base/Planner.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>

#include <memory>
#include <vector>

#include "core/fallback/steering.h"

namespace dualarm {

/// When the tree has been grown enough. An evaluation is a sample drawn or an edge tried.
struct TreeLimits {
  int evaluations = 0;       ///< at most
  int after_first_plan = 0;  ///< at most, once there is a plan to improve on
};

/// A forward tree in a StateTimeSpace: each sampled pair of positions is joined to the near node that gets there
/// first, and every new node tries a direct shot to the goal. Nodes that cannot beat the best plan found are dropped.
/// Needs an ArrivalTime objective, one start and a RestGoal. Reports exact solutions only, each better than the one
/// before. Theory, section 6.
class TreePlanner final : public ompl::base::Planner {
 public:
  TreePlanner(const ompl::base::SpaceInformationPtr& space, TreeLimits limits);
  ~TreePlanner() override;

  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& stop) override;
  void clear() override;
  void getPlannerData(ompl::base::PlannerData& data) const override;

  int evaluations() const { return evaluations_; }

 private:
  struct Node {
    ompl::base::State* state = nullptr;
    const Node* parent = nullptr;
    double bound = 0.0;  ///< s, time + cost-to-go: no plan through this node ends before
  };
  using Neighbours = ompl::NearestNeighborsLinear<const Node*>;

  void plant_root();
  const Node* extend_to(ompl::base::State* target);
  bool try_edge(const Node& from, const ompl::base::State* target);
  const Node* add(const ompl::base::State* state, const Node* parent);
  void shoot_at_goal(const Node& from);
  void report(const Node& goal);
  void prune();
  double cost_to_go(const ompl::base::State* state) const;
  bool worthwhile(double bound) const;
  bool finished() const;

  TreeLimits limits_;
  Neighbours near_;
  std::vector<std::unique_ptr<Node>> nodes_;  ///< dropped ones too: solutions hang on them
  double incumbent_;                          ///< s, duration of the best plan found
  int evaluations_ = 0;
  int evaluations_at_first_plan_ = 0;
};

}  // namespace dualarm
