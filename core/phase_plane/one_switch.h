#pragma once

#include <optional>
#include <vector>

#include "core/model/trajectory.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// The fastest motion between two states as one change between the ends of the admissible accelerations, in closed form
/// but for its turning points: full drive to one side, then to the other, each of them through rest where a state moves
/// the other way. Nothing where it is not as simple as that: where an end of the accelerations depends on the velocity,
/// bends or changes its sign somewhere, where the motion leaves the range or meets the velocity limit, where states or
/// arcs are next to each other, and where no such motion is found. What is answered is what `one_way_motion` finds by
/// walking along both curves, at a fraction of the cost. Theory, sections 1.1 and 1.2.
std::optional<std::vector<Arc>> one_switch_motion(const System& system, JointState start, JointState goal);

}  // namespace dualarm
