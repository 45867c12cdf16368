#include "core/search_planner.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "core/certify.h"
#include "core/exact_starts.h"
#include "core/fallback/state_time_planner.h"
#include "core/passage_choice.h"
#include "core/proven_plan.h"
#include "core/wording.h"

namespace dualarm {
namespace {

/// Gap of an analytic plan above which the search goes on from it, the evaluations that it may take then, and the part
/// of the time left. A plan with a wide gap is no start: it would hold back what goes another way, so the search begins
/// as if there were none.
constexpr double kWorthSearching = 0.01;
constexpr double kWideGap = 0.05;
constexpr int kFurtherEvaluations = 4000;
constexpr double kFurtherShare = 0.5;

/// Part of the time left that the search leaves to the delays and passages which are tried after it.
constexpr double kTurnsShare = 0.1;

/// rad: how far beyond where an arm begins and ends it is worth looking for motions. Farther on all bodies are where
/// they have been before.
constexpr double kTurn = 2.0 * std::numbers::pi;

/// An arm inside its free range as far as the search goes: in the whole of a very wide one it would hit nothing.
Arm searched_arm(const PreparedProblem& prepared, int i) {
  const auto [nearer, farther] =
      std::minmax(prepared.problem().tasks[i].start.position, prepared.problem().tasks[i].goal.position);
  const Interval range = prepared.system(i).range();
  Arm arm = prepared.arm(i);
  arm.joint_range = {std::max(range.lower, nearer - kTurn), std::min(range.upper, farther + kTurn)};
  return arm;
}

/// A schedule of both arms, and the plan that it was proven to be.
struct Incumbent {
  Schedule schedule;
  double duration = 0.0;  ///< s
  std::optional<Plan> plan = {};
};

class SearchPlanner {
 public:
  SearchPlanner(const PreparedProblem& prepared, const PlanningBudget& budget, Findings& findings)
      : prepared_(prepared),
        systems_{SingleJointArm(searched_arm(prepared, 0)), SingleJointArm(searched_arm(prepared, 1))},
        budget_(budget),
        findings_(findings) {}

  std::optional<Plan> plan() {
    findings_.begin("state-time search");
    const SearchResult result = search();
    if (result.schedule) {
      add({*result.schedule, result.duration});
      if (is_at_bound()) return best_proven();
      if (auto exact = with_exact_starts(prepared_, *result.schedule, result.duration, budget_.methods)) {
        add({std::move(exact->schedule), exact->duration});
      }
    }
    if (findings_.passages) take_turns(*findings_.passages);
    return best_proven();
  }

 private:
  SearchResult search() {
    SearchRules rules;
    rules.clearance = prepared_.clearance();
    rules.memory_limit = prepared_.problem().options.search_memory;
    rules.lower_bound = least_duration();
    if (findings_.analytic && findings_.analytic->duration <= (1.0 + kWideGap) * least_duration()) {
      rules.known = findings_.analytic;
      rules.evaluation_limit = kFurtherEvaluations;
    }
    rules.on_incumbent = [this](const Schedule& schedule, double duration) { take(schedule, duration); };
    rules.on_status = [this](int evaluations) {
      findings_.statistics.fallback_evaluation_count = evaluations;
      findings_.begin("state-time search");
    };
    const auto start = Budget::Clock::now();
    const Systems systems = {&systems_[0], &systems_[1]};
    const Budget budget = budget_.methods.part(findings_.analytic ? kFurtherShare : 1.0 - kTurnsShare);
    const SearchResult result = search_state_time(prepared_.problem(), systems, rules, budget);
    Statistics& statistics = findings_.statistics;
    statistics.fallback_seconds = std::chrono::duration<double>(Budget::Clock::now() - start).count();
    statistics.fallback_evaluation_count = result.evaluation_count;
    statistics.fallback_node_count = result.node_count;
    statistics.fallback_memory_bytes = result.memory;
    findings_.tried.push_back(worded("state-time search: ", result.evaluation_count, " evaluations, ",
                                     result.tree_count, result.tree_count == 1 ? " tree" : " trees", " of up to ",
                                     result.node_count, " nodes, ",
                                     result.schedule ? "a schedule found" : "no schedule found",
                                     result.budget_ran_out ? ", stopped by the budget" : ""));
    return result;
  }

  /// Delays and passages, in either order, where they were not allowed on their own: what a search ends with is worth
  /// them, and they find the best of their kind, swings included, exactly.
  void take_turns(const Passages& passages) {
    const PlanOptions& options = prepared_.problem().options;
    const std::array<const Profile*, kArmCount> fastest = {&passages.travellers[0].fastest,
                                                           &passages.travellers[1].fastest};
    if (!options.allows(Method::kDelay)) {
      const Schedule begun_at_once = {std::vector{TimedProfile{0.0, *fastest[0]}}, {TimedProfile{0.0, *fastest[1]}}};
      if (auto delay = with_exact_starts(prepared_, begun_at_once, known_duration(), budget_.methods)) {
        add({std::move(delay->schedule), delay->duration});
      }
    }
    if (options.allows(Method::kPassage)) return;
    if (auto passage = fastest_passage(prepared_, passages, known_duration(), budget_.methods)) {
      const double duration = passage->times.duration;
      add({schedule_of(*std::move(passage)), duration});
    }
  }

  /// Whether nothing faster than the fastest plan known is left to be found.
  bool is_at_bound() const { return known_duration() <= least_duration() * (1.0 + kAtBound); }

  /// s: no plan that keeps the planning margin is faster.
  double least_duration() const {
    return std::max(findings_.bounds.of_every_plan(), findings_.bounds.planned.duration);
  }

  /// s, of the fastest plan known.
  double known_duration() const {
    if (!incumbents_.empty()) return incumbents_.back().duration;
    return findings_.analytic ? findings_.analytic->duration : std::numeric_limits<double>::infinity();
  }

  /// If it is the fastest.
  void add(Incumbent incumbent) {
    if (incumbent.duration < known_duration()) incumbents_.push_back(std::move(incumbent));
  }

  /// What is proven at once for those who watch is proven at the end for the others: the answer is the same. The first
  /// is proven in any case, so that a search that ends late has a plan to fall back on.
  void take(const Schedule& schedule, double duration) {
    if (!(duration < known_duration())) return;
    const bool is_first = incumbents_.empty() && !findings_.analytic;
    incumbents_.push_back({schedule, duration});
    if (is_first || findings_.are_plans_awaited()) incumbents_.back().plan = proven(incumbents_.back());
  }

  std::optional<Plan> best_proven() {
    for (auto incumbent = incumbents_.rbegin(); incumbent != incumbents_.rend(); ++incumbent) {
      if (incumbent->plan) return std::move(incumbent->plan);
      if (budget_.proof.exhausted()) continue;
      if (auto plan = proven(*incumbent)) return plan;
    }
    return std::nullopt;
  }

  std::optional<Plan> proven(const Incumbent& incumbent) {
    return proven_plan(prepared_, Method::kStateTime, incumbent.duration, incumbent.schedule, budget_.proof, findings_);
  }

  const PreparedProblem& prepared_;
  std::array<SingleJointArm, kArmCount> systems_;  ///< schedules refer to them
  const PlanningBudget& budget_;
  Findings& findings_;
  std::vector<Incumbent> incumbents_;  ///< each faster than the one before
};

}  // namespace

bool allows_search(const PlanOptions& options) {
  return options.allows(Method::kStateTime) && options.region_model == RegionModel::kExact;
}

bool is_worth_searching(const Certificate& certificate) {
  return certificate.claim != Claim::kOptimal && certificate.gap > kWorthSearching;
}

std::optional<Plan> plan_by_search(const PreparedProblem& prepared, const PlanningBudget& budget, Findings& findings) {
  return SearchPlanner(prepared, budget, findings).plan();
}

}  // namespace dualarm
