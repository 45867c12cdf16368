#pragma once

#include <variant>
#include <vector>

#include "core/phase_plane/stretches.h"

namespace dualarm {

/// Full braking followed backwards, along the velocity limit where it meets it and as far as braking holds it.
struct BrakingWalk {
  std::vector<Stretch> stretches;  ///< x descends
  double end = 0.0;                ///< x, 0 or where it is driven from rest
  bool from_rest = false;          ///< it ends at rest: what comes before is too fast even from there
};

/// The walk from x back with an energy, at most the limit's.
BrakingWalk walk_back(const Path& path, double x, double energy);

/// The highest energy at each x of the path from which the end can still be passed with `goal_energy` without breaking
/// the velocity limit: full braking backwards from the end, and the limit where braking holds it (the set that can
/// reach the goal, backwards, as in TOPP-RA, but exactly). Stretches ascend in x from 0 to the path's length. An
/// Obstruction (kCannotBrake) where not even rest is low enough.
std::variant<std::vector<Stretch>, Obstruction> braking_ceiling(const Path& path, double goal_energy);

}  // namespace dualarm
