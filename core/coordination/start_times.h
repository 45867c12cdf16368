#pragma once

#include <optional>

#include "core/model/interval_set.h"
#include "core/phase_plane/profile.h"

namespace dualarm {

/// What the choice of start times has to know of a motion.
struct Timing {
  double duration = 0.0;     ///< s, >= 0
  bool may_wait = true;      ///< at rest at its start; otherwise it begins with the plan
  bool may_be_early = true;  ///< at rest at its goal; otherwise it arrives with the plan's end
};

/// The timing of a profile.
Timing timing_of(const Profile& profile);

/// When both arms begin, s from the start of the plan; the earlier one begins at 0 unless moving objects are in the
/// way.
struct StartTimes {
  double first = 0.0;
  double second = 0.0;
  double duration = 0.0;  ///< s, until both have arrived
};

/// The differences `second - first` (s) of start times that two motions allow, wherever bodies are: an interval with
/// ends that may be infinite; empty where one of them would have to be stretched.
Interval possible_delays(const Timing& first, const Timing& second);

/// The start times of shortest duration whose difference `second - first` (s) lies in `safe_delays` and is possible,
/// with the smallest wait among equals. No arm waits longer than `max_delay` (s, >= 0). Nothing if no safe delay is
/// allowed. Theory, section 3.
std::optional<StartTimes> best_start_times(const IntervalSet& safe_delays, const Timing& first, const Timing& second,
                                           double max_delay);

/// What start times have to keep to: sets of which the ends belong to them.
struct SafeStarts {
  IntervalSet delays;  ///< s, of `second - first`
  IntervalSet first;   ///< s from the start of the plan, of arm 1: what moving objects leave it
  IntervalSet second;  ///< the same of arm 2
};

/// The same with moving objects. Each combination of three intervals has an earliest pair of start times, earlier than
/// any other for both arms at once, so that trying these is exact. Theory, section 3.
std::optional<StartTimes> best_start_times(const SafeStarts& safe, const Timing& first, const Timing& second,
                                           double max_delay);

}  // namespace dualarm
