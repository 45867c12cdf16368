#pragma once

#include <optional>

#include "geometry/body.h"
#include "geometry/interval.h"
#include "geometry/lens.h"

namespace dualarm {

/// A body whose distances are a matter of the plane, since joints turn about z: an outline with all heights of an
/// interval, grown in the plane by one radius and then all round by another.
struct Upright {
  Outline outline;
  Interval heights;     ///< m, along z
  double radius = 0.0;  ///< m, of a cylinder: in the plane
  double round = 0.0;   ///< m, of a capsule: all round
};

/// The upright body that a shape is: a capsule along z or at right angles to it, a box with one axis along z, a
/// cylinder along z. Nothing for others. What leans by up to kLean counts, as the upright body around it.
std::optional<Upright> upright(const Shape& shape);

/// m, by how much the points of an upright body may depart from it: what poses on the wire are rounded by.
inline constexpr double kLean = 1e-10;

/// Distance (m) in the plane of two outlines below which their bodies, the first one lifted by `lift` (m), are closer
/// than `distance`; negative if they pass over each other.
double distance_in_plane(const Upright& first, const Upright& second, double lift, double distance);

}  // namespace dualarm
