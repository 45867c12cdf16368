#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "core/phase_plane/extremal.h"
#include "core/phase_plane/path.h"

namespace dualarm {

/// A piece of a curve in the phase plane, from x = `from` to x = `to`: of an extremal, or of the velocity limit.
struct Stretch {
  std::optional<Extremal> arc;  ///< nothing: the velocity limit
  double from = 0.0;
  double to = 0.0;

  ArcKind kind() const { return arc ? arc->kind() : ArcKind::kCruise; }
  double energy_at(const Path& path, double x) const { return arc ? arc->energy_at(x) : path.energy_limit(); }
};

/// What keeps a motion that never turns back from the end of its path.
struct Obstruction {
  enum class Kind {
    kStalls,       ///< even with full drive it comes to rest at x
    kCannotBrake,  ///< from x on full braking cannot keep it from being too fast for the goal
    kOverspeeds,   ///< the start is too fast: not even full braking brings it below what can still be braked
    kFallsShort,   ///< even with full drive it is too slow at the goal
  };
  Kind kind = Kind::kStalls;
  double x = 0.0;
};

/// The fastest motion that never turns back along a path, from energy `start_energy` at 0 to `goal_energy` at its end
/// (both at most the limit's): at each x the highest energy that can be reached from the start and from which the goal
/// can still be met without breaking the velocity limit. Stretches ascend in x from 0 to the path's length. As motions
/// that begin slower stay slower, this highest curve is admissible whenever any is. Theory, section 1.1.
std::variant<std::vector<Stretch>, Obstruction> fastest_stretches(const Path& path, double start_energy,
                                                                  double goal_energy);

}  // namespace dualarm
