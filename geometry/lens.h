#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/interval.h"

namespace dualarm {

/// A segment in the plane, m.
struct Segment {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
};

/// Distance (m) between two segments of the plane, 0 where they cross.
double segment_distance(const Segment& first, const Segment& second);

/// The angles (rad) in `window` by which `turning` may be turned about the origin (counterclockwise) so that it comes
/// closer to `fixed` than or as close as `distance` (m, >= 0): sorted disjoint intervals, in closed form. This is the
/// slice of the forbidden set of two planar capsules at one position of the first arm. Theory, section 2.
std::vector<Interval> colliding_angles(const Segment& fixed, const Segment& turning, double distance, Interval window);

}  // namespace dualarm
