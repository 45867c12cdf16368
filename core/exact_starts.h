#pragma once

#include <optional>

#include "core/fallback/itinerary.h"
#include "core/model/budget.h"
#include "core/prepared_problem.h"

namespace dualarm {

/// Motions of both arms and the time (s) until both have arrived.
struct TimedSchedule {
  Schedule schedule;
  double duration = 0.0;
};

/// The motions of a schedule, in which neither arm waits on its way, with the best start times that exist for them: a
/// search finds them to a part of the duration, section 3 of the theory exactly. Nothing where that is no faster than
/// `duration` (s), where an arm waits, or where the budget runs out.
std::optional<TimedSchedule> with_exact_starts(const PreparedProblem& prepared, const Schedule& schedule,
                                               double duration, const Budget& budget);

}  // namespace dualarm
