#pragma once

#include <optional>

#include "core/fallback/itinerary.h"
#include "core/findings.h"
#include "core/model/budget.h"
#include "core/plan.h"
#include "core/prepared_problem.h"

namespace dualarm {

/// Motions of both arms as they are sent, if they pass verification: nothing else leaves the house. `duration` s, until
/// both have arrived. Otherwise nothing, and the findings say why.
std::optional<Plan> proven_plan(const PreparedProblem& prepared, Method method, double duration,
                                const Schedule& schedule, const Budget& budget, Findings& findings);

}  // namespace dualarm
