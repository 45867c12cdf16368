#include "core/fallback/state_time_planner.h"

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <memory>

#include "core/fallback/arrival_time.h"
#include "core/fallback/fresh_plans.h"
#include "core/fallback/itinerary.h"
#include "core/fallback/known_plan.h"
#include "core/fallback/motion_validator.h"
#include "core/fallback/random.h"
#include "core/fallback/refine.h"
#include "core/fallback/state_time_space.h"
#include "core/fallback/tree_planner.h"

namespace dualarm {
namespace {

namespace ob = ompl::base;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// How many times the evaluations that it may take to shorten plans a search may take to find one.
constexpr int kPatience = 4;

/// Trees that are grown from the start, each until it has a plan: their plans go different ways round. The parts of the
/// evaluations that one of them, once there is a plan at all, and the shortening of what it found may take.
constexpr int kTrees = 4;
constexpr double kTreeShare = 0.04;
constexpr double kFirstRefinementShare = 0.03;

/// Simple plans that are drawn before any tree: the part of the evaluations that they may take, and how many are
/// shortened.
constexpr double kFreshShare = 0.08;
constexpr std::size_t kFresh = 2;

/// Afterwards plans that differ compete in turns of such a part of the evaluations: each is that of the best one which
/// became shorter in its last turn, since the best of all may have come to the end of its way round. How many of the
/// best take part, and the last part of the evaluations, which is the best one's in any case.
constexpr std::size_t kInTurn = 3;
constexpr double kTurnShare = 0.08;
constexpr double kLastShare = 0.06;

/// Plans whose durations differ by no more than this part went the same way round, as a rule.
constexpr double kSameGain = 1e-3;

/// A later tree's plan may be this much longer than the best, which has been shortened, and be worth shortening.
constexpr double kTolerated = 1.6;

/// Part of the last incumbent told by which the next one is shorter.
constexpr double kToldGain = 0.01;

/// The space's time bound, in multiples of the arms' ways across their whole ranges; only bounds what OMPL samples.
constexpr double kHorizonFactor = 10.0;

/// s, where no such way exists.
constexpr double kHorizonWithoutWay = 1e3;

/// Sets the refinement's chances, and those of each tree, apart.
constexpr std::uint64_t kNextSeed = 0x9e3779b97f4a7c15;

double horizon(const Systems& systems, double settled_time) {
  const Interval first = systems[0]->range();
  const Interval second = systems[1]->range();
  const double way =
      std::max(steering_time(systems, at_rest({first.lower, second.lower}), at_rest({first.upper, second.upper})),
               steering_time(systems, at_rest({first.upper, second.upper}), at_rest({first.lower, second.lower})));
  const double free = std::isfinite(way) && way > 0.0 ? kHorizonFactor * way : kHorizonWithoutWay;
  return free + std::max(0.0, settled_time);
}

/// A plan, and whether it hardly became shorter when it was shortened last.
struct Contender {
  Refinement plan;
  bool is_stuck = false;
};

/// One search: its problem put to OMPL, and the best found so far.
class Search {
 public:
  Search(const Problem& problem, const Systems& systems, const SearchRules& rules, const Budget& budget)
      : problem_(problem),
        systems_(systems),
        rules_(rules),
        budget_(budget),
        proof_(problem, rules.clearance, budget),
        start_{problem.tasks[0].start, problem.tasks[1].start},
        goal_{problem.tasks[0].goal, problem.tasks[1].goal},
        horizon_(horizon(systems, proof_.settled_time())),
        random_(problem.options.seed ^ kNextSeed) {
    for (int arm = 0; arm < kArmCount; ++arm) {
      if (goal_[arm].velocity == 0.0) arrivals_.earliest[arm] = proof_.free_from(arm, goal_[arm].position);
    }
    least_ = std::max(
        {rules.lower_bound, minimum_time(systems, start_, goal_), arrivals_.earliest[0], arrivals_.earliest[1]});
  }

  SearchResult run() {
    if (rules_.known) enter_known(*rules_.known);
    enter_fresh();
    for (int tree = 0; (tree < kTrees || !has_plan()) && !is_done(); ++tree) {
      const int before = result_.evaluation_count;
      auto found = grow(tree);
      if (!found && result_.evaluation_count == before) break;  // nothing starts here
      if (found) enter(std::move(*found));
    }
    compete();
    if (best_) {
      result_.schedule = best_->schedule();
      result_.duration = best_->duration();
    }
    result_.budget_ran_out = budget_.exhausted();
    return result_;
  }

 private:
  int share(double part) const { return static_cast<int>(part * rules_.evaluation_limit); }
  int left() const {
    const std::int64_t limit = rules_.evaluation_limit;
    const std::int64_t all = has_plan() ? found_after_ + limit : kPatience * limit;
    return static_cast<int>(std::min<std::int64_t>(all - result_.evaluation_count, std::numeric_limits<int>::max()));
  }
  bool has_plan() const { return best_ || rules_.known; }
  bool is_done() const { return left() <= 0 || budget_.exhausted() || (has_plan() && shortest() <= least_); }

  /// s, of what was found and what was known before.
  double shortest() const {
    const double known = rules_.known ? rules_.known->duration : kInfinity;
    return best_ ? std::min(best_->duration(), known) : known;
  }

  void enter_known(const KnownSchedule& known) {
    const auto itinerary = proven_free(proof_, itinerary_of(systems_, start_, goal_, arrivals_, known.schedule),
                                       problem_.options.max_start_delay);
    if (itinerary) enter(*itinerary);
  }

  PlanRules plan_rules() const { return {least_, problem_.options.max_start_delay}; }

  void enter_fresh() {
    if (is_done() || proof_.slack(positions_of(start_)) <= 0.0) return;
    FreshPlans fresh(systems_, proof_, Itinerary(systems_, start_, arrivals_), goal_, plan_rules(), random_, budget_);
    fresh.run(share(kFreshShare), kTolerated * shortest(), [this](const Itinerary& plan) { tell(plan); });
    count(fresh.evaluations());
    for (Itinerary& plan : fresh.best(kFresh)) enter(std::move(plan));
  }

  /// Takes a plan that was found, or what becomes of it in some evaluations.
  void enter(Itinerary plan) {
    if (!has_plan()) {
      result_.first_duration = plan.duration();
      found_after_ = result_.evaluation_count;
    }
    contenders_.push_back({Refinement(systems_, proof_, std::move(plan), plan_rules(), random_, budget_)});
    take(contenders_.back().plan);
    shorten(contenders_.back(), share(kFirstRefinementShare));
  }

  /// The fastest ones that differ, the fastest first.
  std::vector<Contender*> best_contenders(std::size_t count) {
    std::vector<Contender*> sorted;
    for (Contender& contender : contenders_) sorted.push_back(&contender);
    std::stable_sort(sorted.begin(), sorted.end(), [](const Contender* left, const Contender* right) {
      return left->plan.duration() < right->plan.duration();
    });
    const auto is_like = [](const Contender* left, const Contender* right) {
      return right->plan.duration() < left->plan.duration() * (1.0 + kSameGain);
    };
    sorted.erase(std::unique(sorted.begin(), sorted.end(), is_like), sorted.end());
    sorted.resize(std::min(sorted.size(), count));
    return sorted;
  }

  void compete() {
    if (contenders_.empty()) return;
    while (!is_done() && left() > share(kLastShare)) {
      const int before = result_.evaluation_count;
      shorten(most_promising(), std::clamp(share(kTurnShare), 1, left() - share(kLastShare)));
      if (result_.evaluation_count == before) break;  // it is at its bound
    }
    shorten(*best_contenders(1).front(), left());
  }

  /// The fastest of the best that became shorter when it was shortened last. If none did, all may try again.
  Contender& most_promising() {
    const std::vector<Contender*> best = best_contenders(kInTurn);
    const auto next = std::find_if(best.begin(), best.end(), [](const Contender* one) { return !one->is_stuck; });
    if (next != best.end()) return **next;
    for (Contender& contender : contenders_) contender.is_stuck = false;
    return *best.front();
  }

  void shorten(Contender& contender, int evaluations) {
    if (is_done()) return;
    Refinement& plan = contender.plan;
    const int before = result_.evaluation_count;
    const int own = plan.evaluations();
    const double longer = plan.duration();
    const auto told = [&] {
      result_.evaluation_count = before + plan.evaluations() - own;
      take(plan);
    };
    plan.run(own + std::min(evaluations, left()), told);
    told();
    contender.is_stuck = longer < plan.duration() * (1.0 + kSameGain);
    count(0);
  }

  void take(const Refinement& contender) {
    if (contender.duration() >= shortest()) return;
    best_ = contender.best();
    tell(*best_);
  }

  /// Those who watch, if it is faster by so much that it is worth proving.
  void tell(const Itinerary& plan) {
    if (!rules_.on_incumbent || plan.duration() > std::min(told_ * (1.0 - kToldGain), shortest())) return;
    told_ = plan.duration();
    rules_.on_incumbent(plan.schedule(), told_);
  }

  /// A tree from the start, and the plan that it finds.
  std::optional<Itinerary> grow(int tree) {
    const auto space = std::make_shared<StateTimeSpace>(
        systems_, horizon_, problem_.options.seed + static_cast<std::uint64_t>(tree) * kNextSeed, proof_.settled_time(),
        std::array<JointStates, 2>{start_, goal_});
    const auto information = std::make_shared<ob::SpaceInformation>(space);
    information->setStateValidityChecker(std::make_shared<StateValidity>(information, proof_));
    information->setMotionValidator(std::make_shared<EdgeValidator>(information, proof_));
    information->setup();
    const auto definition = std::make_shared<ob::ProblemDefinition>(information);
    ob::ScopedState<StateTimeSpace> start(information);
    StateTimeSpace::set(start.get(), start_, 0.0);
    definition->addStartState(start);
    definition->setGoal(std::make_shared<StateGoal>(information, goal_));
    definition->setOptimizationObjective(std::make_shared<ArrivalTime>(information));

    TreeLimits limits;
    limits.evaluations = std::min(left(), has_plan() ? share(kTreeShare) : rules_.evaluation_limit);
    limits.nodes = std::max(1, static_cast<int>(rules_.memory_limit / TreePlanner::node_bytes(*information)));
    if (has_plan()) limits.incumbent = kTolerated * shortest();
    limits.max_start_delay = problem_.options.max_start_delay;
    TreePlanner planner(information, limits);
    planner.setProblemDefinition(definition);
    planner.setup();
    planner.solve(ob::PlannerTerminationCondition([this] { return budget_.exhausted(); }));
    count(planner.evaluations());
    ++result_.tree_count;
    result_.node_count = std::max(result_.node_count, planner.most_nodes());
    result_.memory = static_cast<std::size_t>(result_.node_count) * TreePlanner::node_bytes(*information);
    if (!definition->hasExactSolution()) return std::nullopt;
    return itinerary_along(planner.best_edges());
  }

  /// Edges follow from their beginning and their moves.
  std::optional<Itinerary> itinerary_along(const std::vector<Edge>& edges) const {
    Itinerary itinerary(systems_, start_, arrivals_);
    JointStates from = start_;
    double time = 0.0;
    for (const Edge& edge : edges) {
      for (int arm = 0; arm < kArmCount; ++arm) {
        const Move& move = edge.moves[arm];
        if (move.lasts == 0.0) continue;
        const auto motions = motions_of(*systems_[arm], from[arm], move, budget_);
        if (!motions) return std::nullopt;
        for (const Profile& motion : *motions) {
          const bool is_last = &motion == &motions->back();
          itinerary.append(arm, time + move.wait, motion, is_last ? edge.end[arm] : motion.goal_state());
        }
      }
      from = edge.end;
      time += edge.duration;
    }
    return itinerary;
  }

  void count(int evaluations) {
    result_.evaluation_count += evaluations;
    if (rules_.on_status) rules_.on_status(result_.evaluation_count);
  }

  const Problem& problem_;
  const Systems& systems_;
  const SearchRules& rules_;
  const Budget& budget_;
  ClearanceProof proof_;
  JointStates start_;
  JointStates goal_;
  double horizon_;  ///< s
  Arrivals arrivals_;
  double least_ = 0.0;  ///< s, that no plan is below
  Random random_;
  std::deque<Contender> contenders_;  ///< plans that go different ways round, each as short as it has become
  std::optional<Itinerary> best_;     ///< faster than what was known
  int found_after_ = 0;               ///< evaluations, until there was a plan
  double told_ = kInfinity;
  SearchResult result_;
};

}  // namespace

SearchResult search_state_time(const Problem& problem, const Systems& systems, const SearchRules& rules,
                               const Budget& budget) {
  return Search(problem, systems, rules, budget).run();
}

}  // namespace dualarm
