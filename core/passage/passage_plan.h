#pragma once

#include <array>
#include <optional>

#include "core/coordination/forbidden_set.h"
#include "core/coordination/start_times.h"
#include "core/passage/bound.h"

namespace dualarm {

/// Both arms' motions and when they begin.
struct PassagePlan {
  std::array<Profile, kArmCount> motions;
  StartTimes times;
};

/// The two extremal motions through the gate of a way around, within the duration of its bound and at least `least`
/// (s): one begins with the plan, the other ends with it. If they are free, which is not looked at here, no plan is
/// faster. Nothing where an arm would have to wait longer than `max_delay` (s), or cannot wait. Theory, section 4.
std::optional<PassagePlan> extremal_plan(const Travellers& travellers, const Way& way, double least, double max_delay);

/// The fastest pair found of motions of the families through that gate, where the extremal ones clip the forbidden set
/// elsewhere: the duration after the exact best delay is minimised over how far both arms go beyond where they have to,
/// by pattern search. `known` (s) is the duration of a plan that is known already: nothing if no faster one was found,
/// or none at all. No arm waits longer than `max_delay` (s). Theory, section 4.
std::optional<PassagePlan> passage_plan(const ForbiddenSet& forbidden, const Travellers& travellers, const Way& way,
                                        double least, double known, double max_delay, const Budget& budget);

}  // namespace dualarm
