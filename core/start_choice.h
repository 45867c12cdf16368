#pragma once

#include <optional>
#include <string>

#include "core/coordination/forbidden_set.h"
#include "core/coordination/start_times.h"
#include "core/model/budget.h"
#include "core/model/problem.h"

namespace dualarm {

/// When two motions begin, and what that rests on.
struct StartChoice {
  std::optional<StartTimes> times;         ///< the best that are allowed
  std::optional<IntervalSet> safe_delays;  ///< s, start of arm 2 minus start of arm 1; moving objects apart
  std::string why_not;                     ///< a line on why there are no times
};

/// The best start times of a motion of either arm that keep the clearance of `forbidden`, `clearance` (m), from each
/// other and from moving objects, with the methods and the largest start delay that the problem allows. Theory,
/// section 3.
StartChoice choose_starts(const Problem& problem, const ForbiddenSet& forbidden, double clearance, const Profile& first,
                          const Profile& second, const Budget& budget);

}  // namespace dualarm
