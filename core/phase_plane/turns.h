#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "core/model/problem.h"
#include "core/phase_plane/time_optimal.h"

namespace dualarm {

/// A motion as arcs (their times not filled in), or what is in its way.
using ArcsOrBlocked = std::variant<std::vector<Arc>, Blocked>;

/// The fastest motion from `start` to `goal` that turns back at the given positions (rad) and nowhere else. Between two
/// turning points it is the fastest motion that never turns back (stretches.h); a leg of no length is left out. A
/// Blocked answer says what is in the way of the first leg that does not exist, not that nothing else would do.
/// Theory, section 1.2.
ArcsOrBlocked motion_through(const System& system, JointState start, const std::vector<double>& turns, JointState goal);

/// Full braking from a moving state to rest, or why it does not get there inside the range and the limits. No arcs
/// where the way to rest is less than a position can tell.
ArcsOrBlocked stop_from(const System& system, JointState start);

/// Full drive from the nearest position of rest to a moving state, or why there is none: stopping, seen backwards in
/// time.
ArcsOrBlocked run_up_to(const System& system, JointState goal);

/// The motion with the fewest turns whose way is upwards (direction 1) or downwards (-1): against that direction it
/// only brakes from the start, and runs up to the goal. Between them the two ways hold every motion that drives and
/// brakes, or brakes and drives, with one change of torque. Nothing where the way would have to lead backwards; one of
/// the two never has to. Theory, section 1.2.
std::optional<ArcsOrBlocked> one_way_motion(const System& system, JointState start, JointState goal, double direction);

}  // namespace dualarm
