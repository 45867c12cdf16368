#include "core/fallback/tree_planner.h"

#include <ompl/base/PlannerData.h>
#include <ompl/geometric/PathGeometric.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/fallback/arrival_time.h"
#include "core/fallback/sampler.h"
#include "core/fallback/state_time_space.h"

namespace dualarm {
namespace {

namespace ob = ompl::base;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Nodes near a sample that are tried as its parent, besides the root.
constexpr std::size_t kNeighbours = 6;

/// Relative gain in duration below which a better plan is not worth an edge.
constexpr double kWorthwhileGain = 1e-6;

double larger_joint_change(const ob::State* from, const ob::State* to) {
  const JointPair a = StateTimeSpace::positions(from);
  const JointPair b = StateTimeSpace::positions(to);
  return std::max(std::abs(b[0] - a[0]), std::abs(b[1] - a[1]));
}

}  // namespace

TreePlanner::TreePlanner(const ob::SpaceInformationPtr& space, TreeLimits limits)
    : Planner(space, "StateTimeTree"), limits_(limits), incumbent_(kInfinity) {
  specs_.optimizingPaths = true;
  specs_.directed = true;
  near_.setDistanceFunction(
      [](const Node* const& from, const Node* const& to) { return larger_joint_change(from->state, to->state); });
}

TreePlanner::~TreePlanner() { TreePlanner::clear(); }

void TreePlanner::clear() {
  Planner::clear();
  near_.clear();
  for (const auto& node : nodes_) si_->freeState(node->state);
  nodes_.clear();
  incumbent_ = kInfinity;
  evaluations_ = 0;
  evaluations_at_first_plan_ = 0;
}

ob::PlannerStatus TreePlanner::solve(const ob::PlannerTerminationCondition& stop) {
  checkValidity();
  const ob::State* start = pdef_->getStartState(0);
  if (!si_->isValid(start)) return ob::PlannerStatus::INVALID_START;
  if (nodes_.empty()) plant_root();

  auto sampler = std::static_pointer_cast<Sampler>(si_->allocStateSampler());
  const JointPair goal = pdef_->getGoal()->as<RestGoal>()->positions();
  for (int arm = 0; arm < kArmCount; ++arm) {
    sampler->prefer(arm, {StateTimeSpace::positions(start)[arm], goal[arm]});
  }
  ob::State* sample = si_->allocState();
  while (!finished() && !stop()) {
    ++evaluations_;
    sampler->sampleUniform(sample);
    if (!si_->isValid(sample)) continue;
    if (const Node* node = extend_to(sample)) shoot_at_goal(*node);
  }
  si_->freeState(sample);
  return std::isfinite(incumbent_) ? ob::PlannerStatus::EXACT_SOLUTION : ob::PlannerStatus::TIMEOUT;
}

void TreePlanner::plant_root() {
  const Node* root = add(pdef_->getStartState(0), nullptr);
  shoot_at_goal(*root);
}

const TreePlanner::Node* TreePlanner::extend_to(ob::State* target) {
  const Node wanted{target, nullptr, 0.0};
  std::vector<const Node*> parents;
  near_.nearestK(&wanted, kNeighbours, parents);
  const Node* root = nodes_.front().get();
  if (std::find(parents.begin(), parents.end(), root) == parents.end()) parents.push_back(root);

  const auto* space = si_->getStateSpace()->as<StateTimeSpace>();
  const Systems& systems = space->systems();
  const JointPair positions = StateTimeSpace::positions(target);
  const double earliest = space->worth_waiting_for(target);
  std::vector<std::pair<double, const Node*>> arrivals;
  for (const Node* parent : parents) {
    const double way = monotone_time(systems, StateTimeSpace::positions(parent->state), positions);
    arrivals.emplace_back(std::max(earliest, StateTimeSpace::time(parent->state) + way), parent);
  }
  std::stable_sort(arrivals.begin(), arrivals.end(),
                   [](const auto& left, const auto& right) { return left.first < right.first; });
  const double still = cost_to_go(target);
  for (const auto& [arrival, parent] : arrivals) {
    if (!worthwhile(arrival + still) || finished()) break;
    StateTimeSpace::set(target, positions, arrival);
    if (try_edge(*parent, target)) return add(target, parent);
  }
  return nullptr;
}

void TreePlanner::shoot_at_goal(const Node& from) {
  const auto* goal = pdef_->getGoal()->as<RestGoal>();
  const Systems& systems = si_->getStateSpace()->as<StateTimeSpace>()->systems();
  const double way = monotone_time(systems, StateTimeSpace::positions(from.state), goal->positions());
  const double arrival = std::max(goal->not_before(), StateTimeSpace::time(from.state) + way);
  if (!worthwhile(arrival)) return;
  ob::State* target = si_->cloneState(from.state);
  StateTimeSpace::set(target, goal->positions(), arrival);
  if (try_edge(from, target)) report(*add(target, &from));
  si_->freeState(target);
}

bool TreePlanner::try_edge(const Node& from, const ob::State* target) {
  ++evaluations_;
  return si_->checkMotion(from.state, target);
}

const TreePlanner::Node* TreePlanner::add(const ob::State* state, const Node* parent) {
  const double bound = StateTimeSpace::time(state) + cost_to_go(state);
  nodes_.push_back(std::make_unique<Node>(Node{si_->cloneState(state), parent, bound}));
  near_.add(nodes_.back().get());
  return nodes_.back().get();
}

void TreePlanner::report(const Node& goal) {
  if (!std::isfinite(incumbent_)) evaluations_at_first_plan_ = evaluations_;
  incumbent_ = StateTimeSpace::time(goal.state);
  auto path = std::make_shared<ompl::geometric::PathGeometric>(si_);
  for (const Node* node = &goal; node != nullptr; node = node->parent) path->append(node->state);
  path->reverse();
  ob::PlannerSolution solution(path);
  const ob::OptimizationObjectivePtr& objective = pdef_->getOptimizationObjective();
  solution.setOptimized(objective, ob::Cost(incumbent_), objective->isSatisfied(ob::Cost(incumbent_)));
  solution.setPlannerName(getName());
  pdef_->addSolutionPath(solution);
  prune();
}

void TreePlanner::prune() {
  std::vector<const Node*> kept;
  near_.list(kept);
  std::erase_if(kept, [this](const Node* node) { return !worthwhile(node->bound); });
  near_.clear();
  near_.add(kept);
}

bool TreePlanner::worthwhile(double bound) const {
  return std::isfinite(bound) && bound < incumbent_ * (1.0 - kWorthwhileGain);
}

double TreePlanner::cost_to_go(const ob::State* state) const {
  return pdef_->getOptimizationObjective()->costToGo(state, pdef_->getGoal().get()).value();
}

bool TreePlanner::finished() const {
  if (evaluations_ >= limits_.evaluations) return true;
  return std::isfinite(incumbent_) &&
         (evaluations_ >= evaluations_at_first_plan_ + limits_.after_first_plan || !worthwhile(nodes_.front()->bound));
}

void TreePlanner::getPlannerData(ob::PlannerData& data) const {
  Planner::getPlannerData(data);
  for (const auto& node : nodes_) {
    if (node->parent == nullptr) {
      data.addStartVertex(ob::PlannerDataVertex(node->state));
    } else {
      data.addEdge(ob::PlannerDataVertex(node->parent->state), ob::PlannerDataVertex(node->state));
    }
  }
}

}  // namespace dualarm
