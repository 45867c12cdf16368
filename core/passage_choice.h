#pragma once

#include <optional>

#include "core/findings.h"
#include "core/passage/passage_plan.h"
#include "core/prepared_problem.h"

namespace dualarm {

/// Each arm's one motion, when it begins.
Schedule schedule_of(PassagePlan plan);

/// The fastest plan found through the ways that there are for both arms around each other, in both orders, which takes
/// less than `known` (s) and gives way to moving objects. Nothing where there is none. Theory, section 4.
std::optional<PassagePlan> fastest_passage(const PreparedProblem& prepared, const Passages& passages, double known,
                                           const Budget& budget);

}  // namespace dualarm
