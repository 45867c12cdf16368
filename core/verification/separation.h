#pragma once

#include <Eigen/Core>

#include "geometry/body.h"

namespace dualarm {

/// A body that turns about a vertical axis, at the middle of an interval of time, with bounds that hold throughout.
struct TurningBody {
  Capsule capsule;                                 ///< m, world, in the middle
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();  ///< m, world, a point of the axis
  double reach = 0.0;                              ///< m, of any of the body's points from the axis
  double rate = 0.0;                               ///< rad/s, in the middle, positive counterclockwise
  double most_rate = 0.0;                          ///< rad/s, largest magnitude
  double most_rate_change = 0.0;                   ///< rad/s2, largest magnitude
};

/// Lower bound (m) on the distance of two turning bodies over an interval of time, by separation: for any unit vector
/// n(t), the distance is at least min n.x - max n.y over points x of the first and y of the second. `normal` is n in
/// the middle (any unit vector; the bound is tight for the one from the nearest point of the second to that of the
/// first), and n turns with the first or with the second body, whichever proves more. For end points x and y of the
/// axes, n.(x - y) has a known derivative in the middle and a bounded second one, so that the error of the bound falls
/// with the square of the interval where a speed bound's falls with the interval.
double separation_bound(const TurningBody& first, const TurningBody& second, const Eigen::Vector3d& normal,
                        double half_interval);

}  // namespace dualarm
