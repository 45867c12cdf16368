#include "core/planner.h"

#include <chrono>
#include <utility>

#include "core/analytic_planner.h"
#include "core/search_planner.h"

namespace dualarm {
namespace {

double seconds_since(Budget::Clock::time_point start) {
  return std::chrono::duration<double>(Budget::Clock::now() - start).count();
}

}  // namespace

struct PlanningRun::State {
  PlanningBudget budget;
  Budget::Clock::time_point begin = Budget::Clock::now();
  Budget::Clock::duration quick_time{};
  PreparedProblem prepared;
  Findings findings;
  std::optional<Plan> in_hand;  ///< while the search looks for a faster one

  State(const Problem& problem, const Budget& all, const Observer& observer)
      : budget(all), prepared(problem), findings(observer) {}

  Outcome outcome(std::variant<Plan, Infeasible, Undecided> answer) {
    findings.statistics.planning_seconds = seconds_since(begin);
    return {std::move(answer), findings.statistics};
  }
  Outcome undecided() { return outcome(findings.undecided(seconds_since(begin))); }
};

PlanningRun::PlanningRun(const Problem& problem, const Budget& budget, const Observer& observer)
    : state_(std::make_unique<State>(problem, budget, observer)) {}

PlanningRun::~PlanningRun() = default;

std::optional<Outcome> PlanningRun::quick() {
  Findings& findings = state_->findings;
  auto decision = plan_analytically(state_->prepared, state_->budget, findings);
  findings.statistics.analytic_seconds = seconds_since(state_->begin) - findings.statistics.verification_seconds;
  const bool may_search = allows_search(state_->prepared.problem().options);
  auto* plan = decision ? std::get_if<Plan>(&*decision) : nullptr;
  if (plan != nullptr && may_search && is_worth_searching(plan->certificate)) {
    state_->in_hand = std::move(*plan);
  } else if (decision) {
    return std::visit([this](auto&& answer) { return state_->outcome(std::move(answer)); }, *std::move(decision));
  }
  state_->quick_time = Budget::Clock::now() - state_->begin;
  if (may_search) return std::nullopt;
  return state_->undecided();
}

std::optional<Outcome> PlanningRun::in_hand() {
  if (!state_->in_hand) return std::nullopt;
  return state_->outcome(*state_->in_hand);
}

Outcome PlanningRun::search(const Budget& budget) {
  state_->budget = PlanningBudget(budget);
  state_->begin = Budget::Clock::now() - state_->quick_time;  // waiting is not planning
  if (auto plan = plan_by_search(state_->prepared, state_->budget, state_->findings)) {
    return state_->outcome(*std::move(plan));
  }
  if (auto outcome = in_hand()) return *std::move(outcome);
  return state_->undecided();
}

Outcome plan(const Problem& problem, const Budget& budget, const Observer& observer) {
  PlanningRun run(problem, budget, observer);
  if (auto decided = run.quick()) return *std::move(decided);
  return run.search(budget);
}

}  // namespace dualarm
