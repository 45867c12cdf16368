#pragma once

#include <variant>
#include <vector>

#include "core/phase_plane/path.h"
#include "core/phase_plane/time_optimal.h"

namespace dualarm {

/// A piece of a path in the phase plane, from x = `from` to x = `to`: an arc of one kind through an anchor, or the
/// velocity limit (kCruise).
struct Stretch {
  ArcKind kind = ArcKind::kCruise;
  double from = 0.0;
  double to = 0.0;
  double anchor = 0.0;         ///< x of a point that the arc passes
  double anchor_energy = 0.0;  ///< energy there; for kCruise that of the limit

  double energy_at(const Path& path, double x) const {
    return kind == ArcKind::kCruise ? anchor_energy : anchor_energy + path.work(kind, anchor, x - anchor);
  }
};

/// The highest energy at each x of the path from which the goal can still be reached at rest without breaking the
/// velocity limit: full braking backwards from the goal, and the limit where braking holds it. Stretches ascend in x
/// from 0 to the path's length. Blocked (kCannotBrake) where not even rest is low enough. Precondition: braking at the
/// goal is negative.
std::variant<std::vector<Stretch>, Blocked> braking_ceiling(const Path& path);

}  // namespace dualarm
