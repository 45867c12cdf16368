#pragma once

#include <optional>
#include <variant>

#include "core/findings.h"
#include "core/plan.h"
#include "core/planning_budget.h"
#include "core/prepared_problem.h"

namespace dualarm {

/// A plan, or the proof that there is none.
using Decision = std::variant<Plan, Infeasible>;

/// The fastest motions, one of them delayed where they would collide; or motions through a passage, where those are
/// faster or no delay exists. Nothing where these methods decide nothing: what they found out is in the findings.
/// Takes milliseconds. Theory, sections 1 to 5.
std::optional<Decision> plan_analytically(const PreparedProblem& prepared, const PlanningBudget& budget,
                                          Findings& findings);

}  // namespace dualarm
