#pragma once

#include <optional>

#include "core/findings.h"
#include "core/plan.h"
#include "core/planning_budget.h"
#include "core/prepared_problem.h"

namespace dualarm {

/// Whether the problem's options allow the search. It knows the exact set only.
bool allows_search(const PlanOptions& options);

/// Whether the search goes on from a plan of the analytic methods: it is too far above its bound to be left alone.
bool is_worth_searching(const Certificate& certificate);

/// The fastest motions that a search in state-time space found, by exact start delays where that is faster still.
/// Nothing where it found none, or none faster than the analytic plan among the findings, which is where it begins
/// then: the findings say so. Plans that are found on the way are told. Theory, section 6.
std::optional<Plan> plan_by_search(const PreparedProblem& prepared, const PlanningBudget& budget, Findings& findings);

}  // namespace dualarm
