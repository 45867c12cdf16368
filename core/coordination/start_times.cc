#include "core/coordination/start_times.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dualarm {
namespace {

/// Part of the longer duration by which two durations may differ and be the same: what their quadratures leave.
constexpr double kSameDuration = 1e-12;

}  // namespace

Timing timing_of(const Profile& profile) {
  return {profile.duration(), profile.start_state().velocity == 0.0, profile.goal_state().velocity == 0.0};
}

Interval possible_delays(const Timing& first, const Timing& second) {
  // The earlier arm begins at 0, so that arm 1 begins with the plan where the delay is not negative; and arm 1 arrives
  // last where the delay does not exceed what it takes longer.
  const double longer = first.duration - second.duration;
  Interval possible = {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  if (!first.may_wait) possible.lower = 0.0;
  if (!second.may_wait) possible.upper = 0.0;
  if (!first.may_be_early) possible.upper = std::min(possible.upper, longer);
  if (!second.may_be_early) possible.lower = std::max(possible.lower, longer);
  const double rounding = kSameDuration * std::max(first.duration, second.duration);
  if (possible.empty() && possible.lower - possible.upper <= rounding) return {0.0, 0.0};
  return possible;
}

std::optional<StartTimes> best_start_times(const IntervalSet& safe_delays, const Timing& first, const Timing& second,
                                           double max_delay) {
  const Interval possible = possible_delays(first, second);
  // The duration grows with the distance of the delay from zero, once the slack of the shorter motion is used up: so
  // the best delay of an interval is its point nearest to zero.
  std::optional<StartTimes> best;
  for (const Interval& safe : safe_delays.intervals()) {
    const Interval allowed = {std::max(safe.lower, possible.lower), std::min(safe.upper, possible.upper)};
    if (allowed.empty()) continue;
    const double delay = std::clamp(0.0, allowed.lower, allowed.upper);
    if (std::abs(delay) > max_delay) continue;
    StartTimes times = {std::max(0.0, -delay), std::max(0.0, delay), 0.0};
    times.duration = std::max(times.first + first.duration, times.second + second.duration);
    const auto cost = [](const StartTimes& t) { return std::pair(t.duration, t.first + t.second); };
    if (!best || cost(times) < cost(*best)) best = times;
  }
  return best;
}

}  // namespace dualarm
