#pragma once

#include <optional>

#include "core/findings.h"
#include "core/plan.h"
#include "core/planning_budget.h"
#include "core/prepared_problem.h"

namespace dualarm {

/// Whether the problem's options allow the search. It knows the exact set only.
bool allows_search(const PlanOptions& options);

/// Motions with rests on the way, by search. Nothing where it found none: the findings say so. Theory, section 6.
std::optional<Plan> plan_by_search(const PreparedProblem& prepared, const PlanningBudget& budget, Findings& findings);

}  // namespace dualarm
