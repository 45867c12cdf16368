#pragma once

#include <optional>

#include "core/model/budget.h"
#include "core/model/problem.h"
#include "core/phase_plane/profile.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// The fastest motion found that turns back on the way, if it takes less than `known` (s; may be infinite): turning
/// points layer by layer on a grid, every pair joined by the fastest motion that never turns back, then each moved to
/// where the time is least. It searches up to 16 turns, up to one revolution beyond start and goal; when
/// the budget runs out, what it has found by then. Theory, section 1.3.
std::optional<Profile> fastest_swing(const System& system, JointState start, JointState goal, double known,
                                     const Budget& budget);

/// Whether a tenth of that search's work finds any motion that turns back.
bool finds_swing(const System& system, JointState start, JointState goal, const Budget& budget);

}  // namespace dualarm
