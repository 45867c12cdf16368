#include "core/search_planner.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "core/exact_starts.h"
#include "core/fallback/state_time_planner.h"
#include "core/proven_plan.h"
#include "core/wording.h"

namespace dualarm {
namespace {

/// A schedule of both arms, and the plan that it was proven to be.
struct Incumbent {
  Schedule schedule;
  double duration = 0.0;  ///< s
  std::optional<Plan> plan = {};
};

class SearchPlanner {
 public:
  SearchPlanner(const PreparedProblem& prepared, const PlanningBudget& budget, Findings& findings)
      : prepared_(prepared), budget_(budget), findings_(findings) {}

  std::optional<Plan> plan() {
    findings_.begin("state-time search");
    const SearchResult result = search();
    if (!result.schedule) return std::nullopt;
    incumbents_.push_back({*result.schedule, result.duration});
    if (auto exact = with_exact_starts(prepared_, *result.schedule, result.duration, budget_.methods)) {
      incumbents_.push_back({std::move(exact->schedule), exact->duration});
    }
    return best_proven();
  }

 private:
  SearchResult search() {
    SearchRules rules;
    rules.clearance = prepared_.clearance();
    rules.memory_limit = prepared_.problem().options.search_memory;
    rules.lower_bound = std::max(findings_.bounds.of_every_plan(), findings_.bounds.planned.duration);
    rules.on_incumbent = [this](const Schedule& schedule, double duration) { take(schedule, duration); };
    rules.on_status = [this](int evaluations) {
      findings_.statistics.fallback_evaluation_count = evaluations;
      findings_.begin("state-time search");
    };
    const auto start = Budget::Clock::now();
    const Systems systems = {&prepared_.system(0), &prepared_.system(1)};
    const SearchResult result = search_state_time(prepared_.problem(), systems, rules, budget_.methods);
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

  /// What is proven at once for those who watch is proven at the end for the others: the answer is the same. The first
  /// is proven in any case, so that a search that ends late has a plan to fall back on.
  void take(const Schedule& schedule, double duration) {
    const bool is_first = incumbents_.empty();
    incumbents_.push_back({schedule, duration});
    if (is_first || findings_.are_plans_awaited()) incumbents_.back().plan = proven(incumbents_.back());
  }

  std::optional<Plan> best_proven() {
    for (auto incumbent = incumbents_.rbegin(); incumbent != incumbents_.rend(); ++incumbent) {
      if (incumbent->plan) return std::move(incumbent->plan);
      if (auto plan = proven(*incumbent)) return plan;
    }
    return std::nullopt;
  }

  std::optional<Plan> proven(const Incumbent& incumbent) {
    return proven_plan(prepared_, Method::kStateTime, incumbent.duration, incumbent.schedule, budget_.proof, findings_);
  }

  const PreparedProblem& prepared_;
  const PlanningBudget& budget_;
  Findings& findings_;
  std::vector<Incumbent> incumbents_;  ///< each faster than the one before
};

}  // namespace

bool allows_search(const PlanOptions& options) {
  return options.allows(Method::kStateTime) && options.region_model == RegionModel::kExact;
}

std::optional<Plan> plan_by_search(const PreparedProblem& prepared, const PlanningBudget& budget, Findings& findings) {
  return SearchPlanner(prepared, budget, findings).plan();
}

}  // namespace dualarm
