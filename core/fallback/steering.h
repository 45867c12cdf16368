#pragma once

#include <array>
#include <optional>

#include "core/model/problem.h"
#include "core/phase_plane/profile.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// Positions of both arms, rad.
using JointPair = std::array<double, kArmCount>;

/// The arms as the phase plane sees them; whoever keeps them outlives the search and what it returns.
using Systems = std::array<const System*, kArmCount>;

/// The fastest monotone motion from rest to rest of one arm, standing still where it has nowhere to go; none where
/// there is no such motion. Swings are not searched: a search steers thousands of times.
std::optional<Profile> steer(const System& system, double from, double to);

/// Time (s) of both arms' fastest monotone motions from rest to rest, begun together: the slower arm's. Infinite where
/// one of them has none.
double monotone_time(const Systems& systems, const JointPair& from, const JointPair& to);

/// Lower bound (s) on the time that any motions of both arms take from rest to rest, swings included: the larger of
/// what is proven for each arm. Infinite where it is proven that an arm has none.
double minimum_time(const Systems& systems, const JointPair& from, const JointPair& to);

/// True if both arms can stay at rest there: inside their ranges, zero acceleration admissible.
bool holdable(const Systems& systems, const JointPair& positions);

}  // namespace dualarm
