#pragma once

#include <array>
#include <vector>

#include "core/phase_plane/system.h"

namespace dualarm {

inline constexpr std::array kExtremes = {Extreme::kLowest, Extreme::kHighest};

/// Rounding of an acceleration, of SystemSamples::scale.
inline constexpr double kAccelerationRounding = 1e-12;
/// A step (rad or rad/s) over which a continuous acceleration hardly changes.
inline constexpr double kTinyStep = 1e-9;

/// Samples of a system's states, and the size of its accelerations.
struct SystemSamples {
  std::vector<double> everywhere;  ///< rad, ascending: over the range, half its length beyond, and the bends
  std::vector<double> positions;   ///< those in the range
  std::vector<double> velocities;  ///< rad/s, ascending: in both directions to beyond bends and finite limits
  double scale = 0.0;              ///< rad/s2, the largest distance between both ends at standstill

  explicit SystemSamples(const System& system);
};

}  // namespace dualarm
