#pragma once

#include "core/model/budget.h"
#include "core/plan.h"

namespace dualarm {

/// Fastest verified motion of both arms, or why there is none. Analytic methods first; the search in state-time space
/// only where they fail, until the budget is exhausted. Every returned plan has passed `verify`. The same problem gives
/// the same plan; only a budget that runs out can turn a plan of the search into Undecided.
/// Throws std::logic_error for bugs only (a problem that is not valid in the sense of problem.h is one).
Outcome plan(const Problem& problem, const Budget& budget);

}  // namespace dualarm
