#include "core/search_planner.h"

#include <chrono>

#include "core/fallback/state_time_planner.h"
#include "core/object_visit.h"
#include "core/proven_plan.h"
#include "core/wording.h"

namespace dualarm {
namespace {

/// m. The search proves what it finds, and there is no proof of an arrival at the instant at which an object is just
/// far enough.
constexpr double kRoomForProof = 1e-6;

/// When moving objects have left both goals, s.
double earliest_end(const PreparedProblem& prepared) {
  const auto visit = last_goal_visit(prepared.problem(), prepared.clearance() + kRoomForProof);
  return visit ? visit->until : 0.0;
}

}  // namespace

bool allows_search(const PlanOptions& options) {
  return options.allows(Method::kStateTime) && options.region_model == RegionModel::kExact;
}

std::optional<Plan> plan_by_search(const PreparedProblem& prepared, const PlanningBudget& budget, Findings& findings) {
  if (!prepared.rests_at_ends()) {
    findings.tried.push_back("state-time search: not tried, because it plans from rest to rest only");
    return std::nullopt;
  }
  findings.begin("state-time search");
  const auto start = Budget::Clock::now();
  const SearchResult result =
      search_state_time(prepared.problem(), {&prepared.system(0), &prepared.system(1)}, prepared.clearance(),
                        earliest_end(prepared), kDefaultEvaluationLimit, budget.methods);
  findings.statistics.fallback_seconds = std::chrono::duration<double>(Budget::Clock::now() - start).count();
  findings.statistics.fallback_evaluation_count = result.evaluation_count;
  findings.tried.push_back(worded("state-time search: ", result.evaluation_count, " evaluations, ",
                                  result.schedule ? "a schedule found" : "no schedule found",
                                  result.budget_ran_out ? ", stopped by the budget" : ""));
  if (!result.schedule) return std::nullopt;
  return proven_plan(prepared, Method::kStateTime, result.duration, *result.schedule, budget.proof, findings);
}

}  // namespace dualarm
