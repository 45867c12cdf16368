#pragma once

#include <optional>

#include "core/phase_plane/time_optimal.h"

namespace dualarm {

/// The proof, for states between which neither way of one change of torque exists (turns.h), that no motion of any kind
/// does; nothing where there is none. `obstacle` is what is in those ways' way. Full braking from the start, or the
/// run-up to the goal, does not fit into the range; or not even swinging as far as the range allows gains the energy to
/// get past; or that energy is more than a velocity limit allows: then the answer names the limit (kVelocityLimit) and
/// where the system would have to break it. Theory, section 1.3.
std::optional<Blocked> impasse(const System& system, JointState start, JointState goal, const Blocked& obstacle);

/// Whether an obstacle says more about why there is no motion than another one does.
bool tells_more(const System& system, const Blocked& obstacle, const Blocked& other);

}  // namespace dualarm
