#pragma once

#include <Eigen/Core>

#include "geometry/body.h"

namespace dualarm {

/// The point of a shape that lies farthest in a direction (any length but zero), m. Where several do, one of them; on
/// flat parts always a corner or a rim point.
Eigen::Vector3d farthest_point(const Shape& shape, const Eigen::Vector3d& direction);

/// The middle of a shape, which is also its centre of mass, m.
Eigen::Vector3d centre(const Shape& shape);

/// Radius (m) of the smallest ball around `centre` that contains the shape.
double bounding_radius(const Shape& shape);

/// Lower bound (m, perhaps negative) on the distance of a shape and a ball, in some nanoseconds: exact for capsules
/// that do not overlap it, for others the distance of the ball around them.
double distance_to_ball(const Shape& shape, const Eigen::Vector3d& middle, double radius);

}  // namespace dualarm
