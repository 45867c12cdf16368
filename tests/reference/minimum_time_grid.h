#pragma once

#include <optional>
#include <vector>

#include "core/model/arm.h"
#include "core/model/problem.h"

namespace dualarm {

struct GridMotion {
  double duration = 0.0;               ///< s
  double error = 0.0;                  ///< s, of the duration: by what the last refinement of the mesh changed it
  std::vector<double> turning_points;  ///< rad, in order
};

/// The fastest motion of one arm by exhaustive search, sharing nothing with core/phase_plane: all sequences of up to
/// `most_turns` turning points on a grid over the joint range by dynamic programming, the best of each length polished
/// to the last digit; between two turning points the greatest velocity at each position, swept over a mesh of kinetic
/// energies (backward from the end with full braking below the velocity limit, forward from the beginning with full
/// drive below that). Between given turning points the greatest velocity everywhere is the least time, so the
/// duration bounds the minimum from above by no more than `error`. Nothing if no motion was found.
std::optional<GridMotion> minimum_time_by_grid(const Arm& arm, JointState start, JointState goal, int most_turns = 6);

}  // namespace dualarm
