#include "core/verification/body_pair.h"

#include <algorithm>

#include "core/verification/tolerances.h"

namespace dualarm {

DistanceOverTime::DistanceOverTime(const BodyPair& pair, Interval time) : time_(time) {
  const TurningBody first = turning_body(*pair.first, time);
  const TurningBody second = turning_body(*pair.second, time);
  in_the_middle_ = clearance(first.shape, second.shape);
  error_ = clearance_error(first.shape, second.shape);
  by_speed_ = in_the_middle_.distance - error_ - first.farthest_way - second.farthest_way;
  if (has_corner_inside(*pair.first, time) || has_corner_inside(*pair.second, time)) return;
  const Eigen::Vector3d across = in_the_middle_.point_on_first - in_the_middle_.point_on_second;
  const double length = across.norm();
  if (length > kShortestNormal) separation_ = separation(first, second, across / length, 0.5 * time.length());
}

double DistanceOverTime::least_before() const {
  return separation_ ? std::max(by_speed_, separation_->least_before()) : by_speed_;
}

double DistanceOverTime::least_after() const {
  return separation_ ? std::max(by_speed_, separation_->least_after()) : by_speed_;
}

Interval DistanceOverTime::keeps(double distance) const {
  const double middle = 0.5 * (time_.lower + time_.upper);
  if (!separation_) return {middle, middle};
  const auto longest = [&](const std::array<Fall, 2>& falls) {
    const double latest = separation_->half_interval;
    return std::max(falls[0].keeps(distance, latest), falls[1].keeps(distance, latest));
  };
  return {std::max(time_.lower, middle - longest(separation_->before)),
          std::min(time_.upper, middle + longest(separation_->after))};
}

double cut_of(const BodyPair& pair, Interval time) {
  return has_corner_inside(*pair.first, time) ? cut_of(*pair.first, time) : cut_of(*pair.second, time);
}

}  // namespace dualarm
