#pragma once

#include "core/phase_plane/time_optimal.h"

namespace dualarm {

/// Whether it is proven, for states between which neither way of one change of torque exists (turns.h), that no motion
/// of any kind does: full braking from the start, or the run-up to the goal, does not fit into the range, or not even
/// swinging as far as the range allows gains the energy to get past. Theory, section 1.3.
bool is_impasse(const System& system, JointState start, JointState goal);

/// Whether an obstacle says more about why there is no motion than another one does.
bool tells_more(const System& system, const Blocked& obstacle, const Blocked& other);

}  // namespace dualarm
