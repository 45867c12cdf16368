#pragma once

#include <optional>

#include "core/findings.h"
#include "core/plan.h"
#include "core/planning_budget.h"
#include "core/prepared_problem.h"

namespace dualarm {

/// Whether the problem's options allow the search. It knows the exact set only.
bool allows_search(const PlanOptions& options);

/// The fastest motions that a search in state-time space found, by exact start delays where that is faster still.
/// Nothing where it found none: the findings say so. Plans that are found on the way are told. Theory, section 6.
std::optional<Plan> plan_by_search(const PreparedProblem& prepared, const PlanningBudget& budget, Findings& findings);

}  // namespace dualarm
