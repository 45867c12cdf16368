#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "geometry/interval.h"

namespace dualarm {

/// A segment in the plane, m.
struct Segment {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
};

/// A point, a segment, a triangle or a convex quadrangle with its inside: one to four corners in the plane, m, no two
/// alike, counterclockwise.
struct Outline {
  std::array<Eigen::Vector2d, 4> corners = {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(),
                                            Eigen::Vector2d::Zero()};
  int count = 1;
};

/// A segment, or the point it is where it has no length.
Outline outline_of(const Segment& segment);

/// Distance (m) between two segments of the plane, 0 where they cross.
double segment_distance(const Segment& first, const Segment& second);

/// Distance (m) between two outlines, 0 where they overlap.
double outline_distance(const Outline& first, const Outline& second);

/// The angles (rad) in `window` by which `turning` may be turned about the origin (counterclockwise) so that it comes
/// closer to `fixed` than or as close as `distance` (m, >= 0): sorted disjoint intervals, in closed form. This is the
/// slice of the forbidden set of two upright bodies at one position of the first arm. Theory, section 2.
std::vector<Interval> colliding_angles(const Outline& fixed, const Outline& turning, double distance, Interval window);
std::vector<Interval> colliding_angles(const Segment& fixed, const Segment& turning, double distance, Interval window);

}  // namespace dualarm
