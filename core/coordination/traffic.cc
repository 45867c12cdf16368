#include "core/coordination/traffic.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/model/interval_set.h"
#include "geometry/chain.h"
#include "geometry/clearance.h"
#include "geometry/motion_bound.h"
#include "geometry/support.h"

namespace dualarm {
namespace {

/// Rides that are set up between two looks at the budget: a fraction of a millisecond.
constexpr std::size_t kRidesBetweenLooks = 512;

bool is_closer(const Shape& first, const Shape& second, double distance) {
  const double apart = (centre(first) - centre(second)).norm() - bounding_radius(first) - bounding_radius(second);
  return apart <= distance && clearance(first, second).distance <= distance + clearance_error(first, second);
}

}  // namespace

Traffic::Traffic(const Base& base, const std::vector<Body>& bodies, const std::vector<TrackedBody>& objects,
                 double clearance, const Budget& budget)
    : base_(base), clearance_(clearance), budget_(budget) {
  for (const Body& body : bodies) {
    bodies_.push_back({body.shape, reach(body.shape)});
    reach_ = std::max(reach_, bodies_.back().reach);
  }
  for (const TrackedBody& object : objects) add(object);
}

/// What of a track comes within reach of the arm.
void Traffic::add(const TrackedBody& object) {
  const std::vector<TimedPose>& poses = object.track->poses();
  const Eigen::Vector2d axis = base_.position.head<2>();
  const double near = reach_ + clearance_;
  const auto stop = [&](const Eigen::Isometry3d& pose, Interval times) {
    const double away = (pose.translation().head<2>() - axis).norm() - extent(object.body.shape);
    if (!times.empty() && away <= near) stops_.push_back({placed(object.body.shape, pose), times});
  };
  stop(poses.front().pose, {0.0, poses.front().time});
  std::vector<Ride> rides;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    if (i % kRidesBetweenLooks == 0 && budget_.exhausted()) return;  // of what is not looked at nothing is told
    const Ride ride(object.body.shape, poses[i], object.track->segments()[i]);
    const Ball ball = ride.ball();
    const bool is_near = (ball.middle.head<2>() - axis).norm() - ball.radius <= near;
    if (!ride.times().empty() && is_near) rides.push_back(ride);
  }
  if (!rides.empty()) rides_.emplace_back(std::move(rides));
  stop(poses.back().pose, {std::max(0.0, poses.back().time), std::numeric_limits<double>::infinity()});
}

IntervalList Traffic::times(double position, double spread) const {
  std::vector<Interval> found;
  const Eigen::Isometry3d pose = link_pose(base_, position);
  for (const ArmBody& body : bodies_) {
    const Shape here = placed(body.shape, pose);
    const double distance = clearance_ + body.reach * spread;
    for (const Stop& stop : stops_) {
      if (is_closer(here, stop.shape, distance)) found.push_back(stop.times);
    }
    for (const RideTree& rides : rides_) rides.add_meetings(here, distance, budget_, found);
  }
  const IntervalSet united(std::move(found));
  return {united.intervals().begin(), united.intervals().end()};
}

}  // namespace dualarm
