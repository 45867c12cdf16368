#pragma once

#include "geometry/body.h"

namespace dualarm {

/// Distance (m) of two capsules, negative on overlap as for FCL (distance of the axes minus both radii): a second route
/// in long double, by cases (an end against the other axis, four times; both interiors) instead of by clamping.
long double exact_distance(const Capsule& first, const Capsule& second);

/// Distance (m) of any two shapes, in long double: of what has corners by all corners, faces and edges, of cylinders by
/// nested search for the least value of a convex function (some ms, error below 1e-12 of the size). Where the cores (a
/// capsule's axis, all of a box or cylinder) overlap they count as 0 apart; a capsule's radius is taken off.
long double exact_distance(const Shape& first, const Shape& second);

/// What a plane at right angles to a direction (from the second to the first, any length but zero) proves about the
/// distance of two shapes (m, perhaps negative), in long double. No point of one is closer to a point of the other.
long double proven_distance(const Shape& first, const Shape& second, const Eigen::Vector3d& direction);

}  // namespace dualarm
