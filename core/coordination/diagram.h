#pragma once

#include <optional>

#include "core/coordination/forbidden_set.h"
#include "core/model/budget.h"
#include "core/model/interval_set.h"
#include "core/phase_plane/profile.h"

namespace dualarm {

/// Whether two motions might collide with any delay: false where they keep away from each other wherever they are.
bool may_meet(const ForbiddenSet& forbidden, const Profile& first, const Profile& second);

/// The start delays (s, start of arm 2 minus start of arm 1; ends may be infinite) with which two motions collide,
/// which may turn back on the way: the projection of the forbidden set in own-clock coordinates along the diagonal,
/// where an arm before its start and after its arrival stands still. The ends are local extrema polished to rounding,
/// and proven to be the global ones to 1e-4 of the longer duration: a window of safe delays narrower than twice that
/// may be counted as forbidden. Nothing if the budget ran out. Theory, section 3.
std::optional<IntervalSet> forbidden_delays(const ForbiddenSet& forbidden, const Profile& first, const Profile& second,
                                            const Budget& budget);

}  // namespace dualarm
