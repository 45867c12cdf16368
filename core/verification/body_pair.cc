#include "core/verification/body_pair.h"

#include <algorithm>

#include "core/verification/separation.h"
#include "core/verification/tolerances.h"

namespace dualarm {

DistanceOverTime distance_over(const BodyPair& pair, Interval time) {
  const TurningBody first = turning_body(*pair.first, time);
  const TurningBody second = turning_body(*pair.second, time);
  DistanceOverTime result = {clearance(first.shape, second.shape), clearance_error(first.shape, second.shape), 0.0};
  result.lower_bound = result.in_the_middle.distance - result.error - first.farthest_way - second.farthest_way;
  if (has_corner_inside(*pair.first, time) || has_corner_inside(*pair.second, time)) return result;
  const Eigen::Vector3d across = result.in_the_middle.point_on_first - result.in_the_middle.point_on_second;
  const double length = across.norm();
  if (length > kShortestNormal) {
    result.lower_bound =
        std::max(result.lower_bound, separation_bound(first, second, across / length, 0.5 * time.length()));
  }
  return result;
}

double cut_of(const BodyPair& pair, Interval time) {
  return has_corner_inside(*pair.first, time) ? cut_of(*pair.first, time) : cut_of(*pair.second, time);
}

}  // namespace dualarm
