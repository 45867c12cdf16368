// The position of an arm between its knots.
#pragma once

#include <vector>

#include "dualarm/planning/v1/trajectory.pb.h"

namespace dualarm {

/// Position (rad) at `time_s`, by the interpolation rule of Knots (trajectory.proto): the quintic Hermite polynomial
/// between consecutive knots; held before the first and after the last. NaN where the columns are empty or unequal.
double position_at(const planning::v1::Knots& knots, double time_s);

/// Both arms' positions at the same instants: the path in the (theta1, theta2) plane.
struct PathPoint {
  double time;    ///< s
  double theta1;  ///< rad
  double theta2;  ///< rad
};

/// The path at `count` >= 2 equally spaced instants from 0 to `duration_s`.
std::vector<PathPoint> path_of(const planning::v1::Knots& first, const planning::v1::Knots& second, double duration_s,
                               int count);

}  // namespace dualarm
