#include "core/coordination/start_times.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dualarm {

std::optional<StartTimes> best_start_times(const IntervalSet& safe_delays, double first_duration,
                                           double second_duration, double max_delay) {
  // The duration grows with the distance of the delay from zero, once the slack of the shorter motion is used up: so
  // the best delay of an interval is its point nearest to zero.
  std::optional<StartTimes> best;
  for (const Interval& safe : safe_delays.intervals()) {
    const double delay = std::clamp(0.0, safe.lower, safe.upper);
    if (std::abs(delay) > max_delay) continue;
    StartTimes times = {std::max(0.0, -delay), std::max(0.0, delay), 0.0};
    times.duration = std::max(times.first + first_duration, times.second + second_duration);
    const auto cost = [](const StartTimes& t) { return std::pair(t.duration, t.first + t.second); };
    if (!best || cost(times) < cost(*best)) best = times;
  }
  return best;
}

}  // namespace dualarm
