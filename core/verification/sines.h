#pragma once

#include <Eigen/Core>
#include <span>

namespace dualarm {

/// Sines (first column) and cosines (second) of angles (rad), to 1e-15. Neighbours that differ by little, as those
/// along a motion do, share one call of the library: the others follow from it by the addition theorem, with the
/// Taylor series of the small difference.
Eigen::ArrayX2d sines_and_cosines(std::span<const double> angles);

}  // namespace dualarm
