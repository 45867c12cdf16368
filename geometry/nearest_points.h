#pragma once

#include "geometry/body.h"

namespace dualarm {

/// A pair of points of two shapes (m), and what a plane between the shapes proves about their distance (m).
struct NearestPoints {
  Eigen::Vector3d on_first = Eigen::Vector3d::Zero();
  Eigen::Vector3d on_second = Eigen::Vector3d::Zero();
  double lower_bound = 0.0;  ///< 0 where no plane was found, as for shapes that overlap

  double upper_bound() const { return (on_first - on_second).norm(); }
};

/// The largest distance (m, perhaps negative) that planes at right angles to a direction (any length but zero) prove.
double separation(const Shape& first, const Shape& second, const Eigen::Vector3d& direction);

/// Wolfe's minimum norm point of the difference of two shapes: it asks for farthest points only, drops points that turn
/// out to be superfluous, and so stands plates, needles and exact alignment, of which quicker variants of GJK lose
/// their way. `guess` is a direction from the second to the first, any but zero; `size` (m, > 0) that of the scene seen
/// from the origin. Polytopes end after finitely many steps, round bodies when both bounds agree to kNearestPointsGap
/// or no step helps any more. Of shapes almost in touch rounding leaves no direction sharp enough to prove more than
/// their distance less some 1e-8 of the size.
/// P. Wolfe, "Finding the nearest point in a polytope", Mathematical Programming 11 (1976).
NearestPoints nearest_points(const Shape& first, const Shape& second, const Eigen::Vector3d& guess, double size);

/// m per m of the scene: a hundred times the rounding of its coordinates.
inline constexpr double kNearestPointsGap = 1e-13;

}  // namespace dualarm
