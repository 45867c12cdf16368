#include "core/coordination/start_times.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace dualarm {
namespace {

/// Part of the longer duration by which two durations may differ and be the same: what their quadratures leave.
constexpr double kSameDuration = 1e-12;

/// The safe starts (s) at which an arm may begin: none before the plan, and an arm in motion begins with it.
std::vector<Interval> allowed_starts(const IntervalSet& safe, const Timing& timing, double max_delay) {
  const Interval allowed = {0.0, timing.may_wait ? max_delay : 0.0};
  std::vector<Interval> starts;
  for (const Interval& interval : safe.intervals()) {
    const Interval cut = {std::max(interval.lower, allowed.lower), std::min(interval.upper, allowed.upper)};
    if (!cut.empty()) starts.push_back(cut);
  }
  return starts;
}

/// The earliest start times in two intervals with a difference `second - first` in a third. Raising one of them never
/// makes the other one earlier.
std::optional<StartTimes> earliest(const Interval& first, const Interval& second, const Interval& difference) {
  StartTimes times;
  times.first = std::max(first.lower, second.lower - difference.upper);
  times.second = std::max(second.lower, times.first + difference.lower);
  if (times.first > first.upper || times.second > second.upper) return std::nullopt;
  return times;
}

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
  const IntervalSet any({{0.0, std::numeric_limits<double>::infinity()}});
  return best_start_times(SafeStarts{safe_delays, any, any}, first, second, max_delay);
}

std::optional<StartTimes> best_start_times(const SafeStarts& safe, const Timing& first, const Timing& second,
                                           double max_delay) {
  const Interval possible = possible_delays(first, second);
  const std::vector<Interval> starts_of_first = allowed_starts(safe.first, first, max_delay);
  const std::vector<Interval> starts_of_second = allowed_starts(safe.second, second, max_delay);
  std::optional<StartTimes> best;
  for (const Interval& delays : safe.delays.intervals()) {
    const Interval allowed = {std::max(delays.lower, possible.lower), std::min(delays.upper, possible.upper)};
    if (allowed.empty()) continue;
    for (const Interval& of_first : starts_of_first) {
      for (const Interval& of_second : starts_of_second) {
        auto times = earliest(of_first, of_second, allowed);
        if (!times) continue;
        times->duration = std::max(times->first + first.duration, times->second + second.duration);
        const auto cost = [](const StartTimes& t) { return std::pair(t.duration, t.first + t.second); };
        if (!best || cost(*times) < cost(*best)) best = times;
      }
    }
  }
  return best;
}

}  // namespace dualarm
