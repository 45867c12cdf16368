#pragma once

#include <ompl/base/Planner.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>

#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "core/fallback/clearance_proof.h"
#include "core/fallback/edge.h"
#include "core/fallback/random.h"
#include "core/fallback/sampler.h"
#include "core/fallback/steering.h"

namespace dualarm {

/// When the tree has been grown enough, and what its paths have to keep to. An evaluation is a sample drawn or an edge
/// tried.
struct TreeLimits {
  int evaluations = 0;                                               ///< at most
  int after_first_plan = 0;                                          ///< at most, once there is a plan to improve on
  int nodes = std::numeric_limits<int>::max();                       ///< kept at one time, at most
  double incumbent = std::numeric_limits<double>::infinity();        ///< s: only faster plans are of use
  double max_start_delay = std::numeric_limits<double>::infinity();  ///< s, when an arm first moves at the latest
};

/// A forward tree in a StateTimeSpace: each sampled pair of states is joined to the near node that gets there first,
/// and every new node tries direct shots to the goal. An edge ends when both arms are where they were sent, or when the
/// first of them is: the other one is then in motion, and so is the node. Nodes that cannot beat the best plan found
/// are dropped; a full tree is begun anew. Needs an EdgeValidator, an ArrivalTime objective, one start and a StateGoal.
/// Reports exact solutions only, each better than the one before. Theory, section 6.
class TreePlanner final : public ompl::base::Planner {
 public:
  TreePlanner(const ompl::base::SpaceInformationPtr& space, const TreeLimits& limits);
  ~TreePlanner() override;

  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& stop) override;
  void clear() override;
  void getPlannerData(ompl::base::PlannerData& data) const override;

  int evaluations() const { return evaluations_; }

  /// Nodes kept at one time, at most, and what one takes (bytes).
  int most_nodes() const { return most_nodes_; }
  static std::size_t node_bytes(const ompl::base::SpaceInformation& space);

  /// The edges of the best plan found, in order of time; empty if there is none.
  const std::vector<Edge>& best_edges() const { return best_edges_; }

 private:
  struct Node {
    ompl::base::State* state = nullptr;
    const Node* parent = nullptr;
    double bound = 0.0;                          ///< s, time + cost-to-go: no plan through this node ends before
    Edge edge;                                   ///< from the parent
    std::array<bool, kArmCount> has_moved = {};  ///< whether an arm has left its start
  };
  using Neighbours = ompl::NearestNeighborsLinear<const Node*>;

  void plant_root();
  void draw(Sampler& sampler, ompl::base::State* sample) const;
  const Node* extend_to(const ompl::base::State* sample, Random& random);
  const Node* try_edge(const Node& from, const Attempt& attempt, const JointPair& waits, double duration);
  const Node* grow(const Node& from, const JointStates& targets, double not_before, bool cuts_first);
  const Node* add(const Node* parent, const Edge& edge, const JointStates& states, double time);
  void shoot_at_goal(const Node& from, double wait);
  void shoot(const Node& from, const Attempt& attempt, const JointPair& waits, double duration);
  void report(const Node& goal);
  void prune();
  void forget();
  double cost_to_go(const ompl::base::State* state) const;
  bool worthwhile(double bound) const;
  bool finished() const;
  const ClearanceProof& proof() const;

  TreeLimits limits_;
  Neighbours near_;
  std::vector<std::unique_ptr<Node>> nodes_;  ///< dropped ones too: solutions hang on them
  std::vector<Edge> best_edges_;
  double incumbent_;  ///< s, duration of the best plan found or given
  bool is_solved_ = false;
  JointPair goal_free_from_ = {};  ///< s, per arm: until then an object sweeps its goal
  int evaluations_ = 0;
  int evaluations_at_first_plan_ = 0;
  int most_nodes_ = 0;
};

}  // namespace dualarm
