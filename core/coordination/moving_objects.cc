#include "core/coordination/moving_objects.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/coordination/projection.h"
#include "core/coordination/ride.h"
#include "geometry/chain.h"
#include "geometry/clearance.h"
#include "geometry/motion_bound.h"
#include "geometry/support.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A body that stands still during an interval of time (s).
struct Stop {
  Shape shape;
  Interval times;
};

/// The objects on their tracks, as an arm meets them.
class Traffic final : public Meetings {
 public:
  Traffic(const Base& base, const std::vector<Body>& bodies, const std::vector<TrackedBody>& objects, double clearance)
      : base_(base), clearance_(clearance) {
    for (const Body& body : bodies) {
      bodies_.push_back({body.shape, reach(body.shape)});
      reach_ = std::max(reach_, bodies_.back().reach);
    }
    for (const TrackedBody& object : objects) add(object);
  }

  std::vector<Interval> times_at(double position) const override { return times(position, 0.0); }
  std::vector<Interval> times_over(Interval positions) const override {
    return times(0.5 * (positions.lower + positions.upper), 0.5 * positions.length());
  }

 private:
  struct ArmBody {
    Shape shape;  ///< in the link frame
    double reach = 0.0;
  };

  /// What of a track comes within reach of the arm.
  void add(const TrackedBody& object) {
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
      const Ride ride(object.body.shape, poses[i], object.track->segments()[i]);
      const Ball ball = ride.ball();
      const bool is_near = (ball.middle.head<2>() - axis).norm() - ball.radius <= near;
      if (!ride.times().empty() && is_near) rides.push_back(ride);
    }
    if (!rides.empty()) rides_.emplace_back(std::move(rides));
    stop(poses.back().pose, {std::max(0.0, poses.back().time), kInfinity});
  }

  std::vector<Interval> times(double position, double spread) const {
    std::vector<Interval> found;
    const Eigen::Isometry3d pose = link_pose(base_, position);
    for (const ArmBody& body : bodies_) {
      const Shape here = placed(body.shape, pose);
      const double distance = clearance_ + body.reach * spread;
      for (const Stop& stop : stops_) {
        if (is_closer(here, stop.shape, distance)) found.push_back(stop.times);
      }
      for (const RideTree& rides : rides_) rides.add_meetings(here, distance, found);
    }
    return IntervalSet(std::move(found)).intervals();
  }

  static bool is_closer(const Shape& first, const Shape& second, double distance) {
    const double apart = (centre(first) - centre(second)).norm() - bounding_radius(first) - bounding_radius(second);
    return apart <= distance && clearance(first, second).distance <= distance + clearance_error(first, second);
  }

  Base base_;
  double clearance_;
  double reach_ = 0.0;  ///< m, of all bodies of the arm
  std::vector<ArmBody> bodies_;
  std::vector<Stop> stops_;
  std::vector<RideTree> rides_;  ///< one an object
};

}  // namespace

std::optional<IntervalSet> forbidden_starts(const Profile& motion, const Base& base, const std::vector<Body>& bodies,
                                            const std::vector<TrackedBody>& objects, double clearance,
                                            const Budget& budget) {
  if (objects.empty()) return IntervalSet();
  const Traffic traffic(base, bodies, objects, clearance);
  const bool stays = motion.goal_state().velocity == 0.0;
  const auto differences = project(traffic, motion, {motion.duration(), stays}, budget);
  if (!differences) return std::nullopt;
  std::vector<Interval> starts;
  for (const Interval& own_minus_other : differences->intervals()) {
    starts.push_back({-own_minus_other.upper, -own_minus_other.lower});
  }
  return IntervalSet(std::move(starts));
}

double last_meeting(double position, const Base& base, const std::vector<Body>& bodies, const TrackedBody& object,
                    double clearance) {
  const std::vector<Interval> times = Traffic(base, bodies, {object}, clearance).times_at(position);
  return times.empty() ? -kInfinity : times.back().upper;
}

}  // namespace dualarm
