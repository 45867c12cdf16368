#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/model/budget.h"
#include "core/model/problem.h"
#include "core/phase_plane/profile.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// Positions of both arms, rad.
using JointPair = std::array<double, kArmCount>;

/// Positions and velocities of both arms.
using JointStates = std::array<JointState, kArmCount>;

/// The arms as the phase plane sees them; whoever keeps them outlives the search and what it returns.
using Systems = std::array<const System*, kArmCount>;

inline JointPair positions_of(const JointStates& states) { return {states[0].position, states[1].position}; }

/// Both arms at rest.
inline JointStates at_rest(const JointPair& positions) {
  return {JointState{positions[0], 0.0}, JointState{positions[1], 0.0}};
}

/// The fastest motion of one arm between any two states, standing still where it has nowhere to go; none where there
/// is no such motion. Swings are not searched: a search steers thousands of times. Theory, section 1.2.
std::optional<Profile> steer(const System& system, JointState from, JointState to);

/// Its duration (s), in half the time; infinite where there is none.
double steering_time(const System& system, JointState from, JointState to);

/// What a motion does until a time (s) of its own clock, inside it. Nothing where that is so close to one of its
/// switches that what is left of an arc could not be told from rounding.
std::optional<Profile> cut(const System& system, const Profile& motion, double time);

/// The fastest motion slowed down so that it takes `duration` (s) without standing still on the way: half way through
/// it passes with less speed. One profile where nothing has to be slowed down, else two, the second beginning in the
/// state in which the first ends. Nothing where the arm cannot be that slow, or that fast, or the budget runs out.
std::optional<std::vector<Profile>> stretched(const System& system, JointState from, JointState to, double duration,
                                              const Budget& budget = Budget());

/// Time (s) of both arms' steered motions, begun together: the slower arm's. Infinite where one of them has none.
double steering_time(const Systems& systems, const JointStates& from, const JointStates& to);

/// Lower bound (s) on the time that any motions of both arms take, swings included: the larger of what is proven for
/// each arm. Infinite where it is proven that an arm has none.
double minimum_time(const Systems& systems, const JointStates& from, const JointStates& to);

/// rad/s: the larger of an arm's velocity limits, where it has one; for velocities that are drawn.
double velocity_scale(const System& system);

/// True if an arm can stay in a state: at rest inside its range, zero acceleration admissible.
bool can_hold(const System& system, JointState state);

}  // namespace dualarm
