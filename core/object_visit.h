#pragma once

#include <optional>

#include "core/model/budget.h"
#include "core/plan.h"

namespace dualarm {

/// The visit at either goal, closer than `clearance` (m), that ends last. None where no object comes to a goal. An arm
/// that arrives stays, so that no plan ends before; an arm that is in motion at its goal is expected nowhere afterwards
/// and has none.
std::optional<ObjectVisit> last_goal_visit(const Problem& problem, double clearance, const Budget& budget);

/// The visit that ends at a time (s), `until`, of an arm that stands at a position (rad), with its names.
ObjectVisit visit_until(const Problem& problem, int arm, double position, double clearance, double until,
                        const Budget& budget);

/// Of a visit without an end: an object stays on an arm's goal, or between its start and its goal. `margin` (m): what
/// is planned with beyond what is demanded.
Infeasible refuse_visit(const Problem& problem, const ObjectVisit& visit, double margin);

}  // namespace dualarm
