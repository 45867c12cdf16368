#include "core/fallback/tree_planner.h"

#include <ompl/base/PlannerData.h>
#include <ompl/geometric/PathGeometric.h>

#include <algorithm>
#include <cmath>

#include "core/fallback/arrival_time.h"
#include "core/fallback/motion_validator.h"
#include "core/fallback/sampler.h"
#include "core/fallback/state_time_space.h"

namespace dualarm {
namespace {

namespace ob = ompl::base;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Nodes near a sample that are tried as its parent, besides the root.
constexpr std::size_t kNeighbours = 5;

/// How often an arm stays where its parent node has it, if it can.
constexpr double kHoldShare = 0.15;

/// How often an edge that ends when the first arm is there is tried before one on which both get there.
constexpr double kCutShare = 0.3;

/// How often a sample lies near a node.
constexpr double kNearShare = 0.3;

/// Relative gain in duration below which a better plan is not worth an edge.
constexpr double kWorthwhileGain = 1e-6;

}  // namespace

TreePlanner::TreePlanner(const ob::SpaceInformationPtr& space, const TreeLimits& limits)
    : Planner(space, "StateTimeTree"), limits_(limits), incumbent_(limits.incumbent) {
  specs_.optimizingPaths = true;
  specs_.directed = true;
  const auto* states = space->getStateSpace()->as<StateTimeSpace>();
  near_.setDistanceFunction([states](const Node* const& from, const Node* const& to) {
    return states->difference(StateTimeSpace::states(from->state), StateTimeSpace::states(to->state));
  });
}

TreePlanner::~TreePlanner() { TreePlanner::clear(); }

void TreePlanner::clear() {
  Planner::clear();
  near_.clear();
  for (const auto& node : nodes_) si_->freeState(node->state);
  nodes_.clear();
  best_edges_.clear();
  incumbent_ = limits_.incumbent;
  is_solved_ = false;
  evaluations_ = 0;
  evaluations_at_first_plan_ = 0;
  most_nodes_ = 0;
}

std::size_t TreePlanner::node_bytes(const ob::SpaceInformation& space) {
  constexpr std::size_t kAllocations = 6;  // the node, its state, that state's parts, and the places in two lists
  constexpr std::size_t kOverhead = 32;    // bytes, of an allocation
  const std::size_t numbers = space.getStateDimension() * sizeof(double);
  return sizeof(Node) + numbers + kAllocations * kOverhead + 4 * sizeof(void*);
}

const ClearanceProof& TreePlanner::proof() const {
  return static_cast<const EdgeValidator&>(*si_->getMotionValidator()).proof();
}

ob::PlannerStatus TreePlanner::solve(const ob::PlannerTerminationCondition& stop) {
  checkValidity();
  const ob::State* start = pdef_->getStartState(0);
  if (!si_->isValid(start)) return ob::PlannerStatus::INVALID_START;
  const JointStates goal = pdef_->getGoal()->as<StateGoal>()->states();
  auto sampler = std::static_pointer_cast<Sampler>(si_->allocStateSampler());
  for (int arm = 0; arm < kArmCount; ++arm) {
    sampler->prefer(arm, {StateTimeSpace::states(start)[arm], goal[arm]});
    goal_free_from_[arm] = goal[arm].velocity == 0.0 ? proof().free_from(arm, goal[arm].position) : -kInfinity;
  }
  if (nodes_.empty()) plant_root();
  ob::State* sample = si_->allocState();
  while (!finished() && !stop()) {
    ++evaluations_;
    draw(*sampler, sample);
    if (proof().slack(positions_of(StateTimeSpace::states(sample))) <= 0.0) continue;
    if (const Node* node = extend_to(sample, sampler->random())) {
      shoot_at_goal(*node, std::max(0.0, si_->getStateSpace()->as<StateTimeSpace>()->worth_waiting_for(sample) -
                                             StateTimeSpace::time(node->state)));
    }
    if (static_cast<int>(nodes_.size()) >= limits_.nodes) forget();
  }
  si_->freeState(sample);
  return is_solved_ ? ob::PlannerStatus::EXACT_SOLUTION : ob::PlannerStatus::TIMEOUT;
}

/// Anywhere, or near a node: where it is narrow, most ways to anywhere are blocked.
void TreePlanner::draw(Sampler& sampler, ob::State* sample) const {
  Random& random = sampler.random();
  if (!random.chance(kNearShare)) return sampler.sampleUniform(sample);
  const auto& node = nodes_[random.below(static_cast<int>(nodes_.size()))];
  JointStates states = StateTimeSpace::states(node->state);
  const auto* space = si_->getStateSpace()->as<StateTimeSpace>();
  for (int arm = 0; arm < kArmCount; ++arm) {
    const Interval range = space->systems()[arm]->range();
    const double position = states[arm].position + random.step() * range.length();
    states[arm] = {std::clamp(position, range.lower, range.upper), 0.0};
  }
  StateTimeSpace::set(sample, states, random.in({0.0, space->getMaximumExtent()}));
}

void TreePlanner::plant_root() {
  const ob::State* start = pdef_->getStartState(0);
  const Node* root = add(nullptr, Edge{}, StateTimeSpace::states(start), StateTimeSpace::time(start));
  shoot_at_goal(*root, 0.0);
}

const TreePlanner::Node* TreePlanner::extend_to(const ob::State* sample, Random& random) {
  Node wanted;
  wanted.state = const_cast<ob::State*>(sample);  // NearestNeighbors compares nodes; nothing writes to it
  std::vector<const Node*> parents;
  near_.nearestK(&wanted, kNeighbours, parents);
  const Node* root = nodes_.front().get();
  if (std::find(parents.begin(), parents.end(), root) == parents.end()) parents.push_back(root);

  const auto* space = si_->getStateSpace()->as<StateTimeSpace>();
  const Systems& systems = space->systems();
  const double earliest = space->worth_waiting_for(sample);
  const bool cuts_first = random.chance(kCutShare);
  const std::array<bool, kArmCount> holds = {random.chance(kHoldShare), random.chance(kHoldShare)};
  struct Choice {
    double arrival;
    const Node* parent;
    JointStates targets;
  };
  std::vector<Choice> choices;
  for (const Node* parent : parents) {
    const JointStates from = StateTimeSpace::states(parent->state);
    JointStates targets = StateTimeSpace::states(sample);
    for (int arm = 0; arm < kArmCount; ++arm) {
      if (holds[arm] && can_hold(*systems[arm], from[arm])) targets[arm] = from[arm];
    }
    if (targets == from) continue;
    choices.push_back({StateTimeSpace::time(parent->state) + steering_time(systems, from, targets), parent, targets});
  }
  std::stable_sort(choices.begin(), choices.end(),
                   [](const Choice& left, const Choice& right) { return left.arrival < right.arrival; });
  for (const Choice& choice : choices) {
    if (!worthwhile(choice.arrival) || finished()) break;
    if (const Node* node = grow(*choice.parent, choice.targets, earliest, cuts_first)) return node;
  }
  return nullptr;
}

/// Edges to targets: both begin at once, or each as late as it can, or until the first one is there.
const TreePlanner::Node* TreePlanner::grow(const Node& from, const JointStates& targets, double not_before,
                                           bool cuts_first) {
  const auto* space = si_->getStateSpace()->as<StateTimeSpace>();
  const double time = StateTimeSpace::time(from.state);
  const Attempt attempt(space->systems(), proof(), StateTimeSpace::states(from.state), time, targets);
  if (!attempt.is_possible()) return nullptr;
  const double both = std::max(attempt.duration(0), attempt.duration(1));
  const double one = std::min(attempt.duration(0), attempt.duration(1));
  const double end = std::max(both, not_before - time);
  JointPair late = {};
  for (int arm = 0; arm < kArmCount; ++arm) {
    if (attempt.can_wait(arm)) late[arm] = end - attempt.duration(arm);
  }
  const auto until_first = [&] { return one > 0.0 ? try_edge(from, attempt, {0.0, 0.0}, one) : nullptr; };
  if (cuts_first) {
    if (const Node* node = until_first()) return node;
  }
  if (end == both) {
    if (const Node* node = try_edge(from, attempt, {0.0, 0.0}, both)) return node;
  }
  if (late != JointPair{0.0, 0.0}) {
    if (const Node* node = try_edge(from, attempt, late, end)) return node;
  }
  return cuts_first ? nullptr : until_first();
}

const TreePlanner::Node* TreePlanner::try_edge(const Node& from, const Attempt& attempt, const JointPair& waits,
                                               double duration) {
  const double time = StateTimeSpace::time(from.state);
  for (int arm = 0; arm < kArmCount; ++arm) {
    const bool leaves = !from.has_moved[arm] && attempt.duration(arm) > 0.0 && waits[arm] < duration;
    if (leaves && time + waits[arm] > limits_.max_start_delay) return nullptr;
  }
  if (!worthwhile(time + duration)) return nullptr;
  ++evaluations_;
  const auto edge = attempt.edge(waits, duration);
  return edge ? add(&from, *edge, edge->end, time + duration) : nullptr;
}

/// Waits are tried from none to one arm after the other.
void TreePlanner::shoot_at_goal(const Node& from, double wait) {
  const JointStates goal = pdef_->getGoal()->as<StateGoal>()->states();
  const double time = StateTimeSpace::time(from.state);
  if (!worthwhile(from.bound)) return;
  const Attempt attempt(si_->getStateSpace()->as<StateTimeSpace>()->systems(), proof(),
                        StateTimeSpace::states(from.state), time, goal);
  if (!attempt.is_possible()) return;
  JointPair soonest;
  for (int arm = 0; arm < kArmCount; ++arm) {
    soonest[arm] = std::max(0.0, goal_free_from_[arm] - time - attempt.duration(arm));
    if (std::isinf(soonest[arm]) || (soonest[arm] > 0.0 && !attempt.can_wait(arm))) return;
  }
  const auto arrival = [&](const JointPair& waits, int arm) { return waits[arm] + attempt.duration(arm); };
  const double together = std::max(arrival(soonest, 0), arrival(soonest, 1));
  std::vector<JointPair> tries = {soonest};
  const auto add_try = [&](double first, double second) {
    const JointPair waits = {std::max(soonest[0], first), std::max(soonest[1], second)};
    if (std::find(tries.begin(), tries.end(), waits) == tries.end()) tries.push_back(waits);
  };
  add_try(together - attempt.duration(0), together - attempt.duration(1));
  for (const double part : {0.5, 1.0}) {
    add_try(0.0, part * attempt.duration(0));
    add_try(part * attempt.duration(1), 0.0);
  }
  if (wait > 0.0) {
    add_try(wait, wait);
    add_try(0.0, wait);
    add_try(wait, 0.0);
  }
  for (JointPair waits : tries) {
    if (proof().budget().exhausted()) return;
    const double end = std::max(arrival(waits, 0), arrival(waits, 1));
    std::optional<Attempt> slower;
    bool is_possible = true;
    for (int arm = 0; arm < kArmCount; ++arm) {
      if (waits[arm] > 0.0 && !attempt.can_wait(arm)) is_possible = false;
      if (goal[arm].velocity == 0.0 || arrival(waits, arm) == end) continue;
      if (attempt.can_wait(arm)) {
        waits[arm] = end - attempt.duration(arm);
      } else {
        if (!slower) slower = attempt;
        is_possible = is_possible && slower->stretch(arm, end);
      }
    }
    if (is_possible && worthwhile(time + end)) shoot(from, slower ? *slower : attempt, waits, end);
  }
}

void TreePlanner::shoot(const Node& from, const Attempt& attempt, const JointPair& waits, double duration) {
  if (duration > 0.0) {
    if (const Node* goal = try_edge(from, attempt, waits, duration)) report(*goal);
  } else if (proof().slack(positions_of(StateTimeSpace::states(from.state))) > 0.0) {
    report(from);
  }
}

const TreePlanner::Node* TreePlanner::add(const Node* parent, const Edge& edge, const JointStates& states,
                                          double time) {
  auto node = std::make_unique<Node>();
  node->state = si_->allocState();
  StateTimeSpace::set(node->state, states, time);
  node->parent = parent;
  node->edge = edge;
  for (int arm = 0; arm < kArmCount && parent != nullptr; ++arm) {
    node->has_moved[arm] = parent->has_moved[arm] || edge.moves[arm].lasts > 0.0;
  }
  node->bound = std::max({time + cost_to_go(node->state), goal_free_from_[0], goal_free_from_[1]});
  nodes_.push_back(std::move(node));
  most_nodes_ = std::max(most_nodes_, static_cast<int>(nodes_.size()));
  near_.add(nodes_.back().get());
  return nodes_.back().get();
}

void TreePlanner::report(const Node& goal) {
  if (!is_solved_) evaluations_at_first_plan_ = evaluations_;
  is_solved_ = true;
  incumbent_ = StateTimeSpace::time(goal.state);
  si_->getStateSpace()->as<StateTimeSpace>()->shrink(incumbent_);
  best_edges_.clear();
  auto path = std::make_shared<ompl::geometric::PathGeometric>(si_);
  for (const Node* node = &goal; node != nullptr; node = node->parent) {
    path->append(node->state);
    if (node->parent != nullptr) best_edges_.push_back(node->edge);
  }
  path->reverse();
  std::reverse(best_edges_.begin(), best_edges_.end());
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

/// A tree that is full is begun anew, with the samples that come: its solutions are copies of their states.
void TreePlanner::forget() {
  near_.clear();
  for (const auto& node : nodes_) si_->freeState(node->state);
  nodes_.clear();
  plant_root();
}

bool TreePlanner::worthwhile(double bound) const {
  return std::isfinite(bound) && bound < incumbent_ * (1.0 - kWorthwhileGain);
}

double TreePlanner::cost_to_go(const ob::State* state) const {
  return pdef_->getOptimizationObjective()->costToGo(state, pdef_->getGoal().get()).value();
}

bool TreePlanner::finished() const {
  if (evaluations_ >= limits_.evaluations || !worthwhile(nodes_.front()->bound)) return true;
  return is_solved_ && evaluations_ >= evaluations_at_first_plan_ + limits_.after_first_plan;
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
