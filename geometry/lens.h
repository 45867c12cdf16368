#pragma once

#include <Eigen/Core>
#include <array>

#include "geometry/interval.h"
#include "geometry/interval_list.h"
#include "geometry/outline.h"

namespace dualarm {

/// A figure that turns about the origin, with what every slice asks of it.
struct Spinner {
  Figure figure;
  std::array<double, 4> radius = {};  ///< m, of the corners from the origin
  double farthest = 0.0;              ///< m, of the corners
  double nearest = 0.0;               ///< m, of the whole figure
};

Spinner spinner_of(const Outline& outline);

/// The angles (rad) in `window` by which `turning` may be turned about the origin (counterclockwise) so that it comes
/// closer to `fixed` than or as close as `distance` (m, >= 0): sorted disjoint intervals, in closed form. This is the
/// slice of the forbidden set of two upright bodies at one position of the first arm. Theory, section 2.
IntervalList colliding_angles(const Figure& fixed, const Spinner& turning, double distance, Interval window);
IntervalList colliding_angles(const Outline& fixed, const Outline& turning, double distance, Interval window);
IntervalList colliding_angles(const Segment& fixed, const Segment& turning, double distance, Interval window);

}  // namespace dualarm
