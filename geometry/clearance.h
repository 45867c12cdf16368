#pragma once

#include <Eigen/Core>

#include "geometry/body.h"

namespace dualarm {

/// Gap between two bodies in one frame, judged by FCL, with the pair of nearest points (m). Where they overlap the
/// distance is not positive: of two capsules the signed one (segment distance minus both radii), of a capsule and
/// another body that of its axis minus its radius, with 0 as the distance of what overlaps. Where cores overlap (a
/// capsule's core is its axis, another body's all of it), both points are one that the cores share.
struct Clearance {
  double distance = 0.0;
  Eigen::Vector3d point_on_first = Eigen::Vector3d::Zero();
  Eigen::Vector3d point_on_second = Eigen::Vector3d::Zero();
};

/// FCL's distance of two shapes given in the same frame: closed form for two capsules, GJK (libccd) for the rest. What
/// GJK says is believed only as far as a plane between the bodies, at right angles to the line of its nearest points,
/// proves it.
Clearance clearance(const Capsule& first, const Capsule& second);
Clearance clearance(const Shape& first, const Shape& second);

/// Upper bound (m) on how much `clearance` may overstate the distance of these two: FCL's closed form for capsules
/// loses digits on nearly parallel pairs, and the rim of a wafer of a cylinder is where the rounding of its short axis
/// leaves it. Holds within 10 km of the origin, wherever there a pose has placed the shapes. A proof subtracts it.
double clearance_error(const Shape& first, const Shape& second);

}  // namespace dualarm
