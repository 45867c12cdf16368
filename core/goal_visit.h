#pragma once

#include <optional>

#include "core/plan.h"

namespace dualarm {

/// The visit at either goal, closer than `clearance` (m), that ends last. None where no object comes to a goal. An arm
/// that arrives stays, so that no plan ends before; an arm that is in motion at its goal is expected nowhere afterwards
/// and has none.
std::optional<GoalVisit> last_goal_visit(const Problem& problem, double clearance);

/// Of a visit without an end: an object parks on a goal. `margin` (m): what is planned with beyond what is demanded.
Infeasible refuse_goal_visit(const Problem& problem, const GoalVisit& visit, double margin);

}  // namespace dualarm
