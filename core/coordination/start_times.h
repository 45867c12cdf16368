#pragma once

#include <optional>

#include "core/model/interval_set.h"

namespace dualarm {

/// When both arms begin, s from the start of the plan; the earlier one begins at 0.
struct StartTimes {
  double first = 0.0;
  double second = 0.0;
  double duration = 0.0;  ///< s, until both have arrived
};

/// The start times of shortest duration whose difference `second - first` lies in `safe_delays`, with the smallest wait
/// among equals. `first_duration` and `second_duration` (s) are the arms' own; no arm waits longer than `max_delay`
/// (s). Nothing if no safe delay is allowed. Theory, section 3.
std::optional<StartTimes> best_start_times(const IntervalSet& safe_delays, double first_duration,
                                           double second_duration, double max_delay);

}  // namespace dualarm
