#include "core/coordination/ride.h"

#include <algorithm>
#include <utility>

#include "geometry/motion_bound.h"
#include "geometry/support.h"

namespace dualarm {
namespace {

/// The smallest ball around two balls.
Ball around(const Ball& first, const Ball& second) {
  const Eigen::Vector3d across = second.middle - first.middle;
  const double apart = across.norm();
  if (apart + second.radius <= first.radius) return first;
  if (apart + first.radius <= second.radius) return second;
  const double radius = 0.5 * (apart + first.radius + second.radius);
  return {first.middle + across * ((radius - first.radius) / apart), radius};
}

/// Of the rides from begin to end the one in the middle stands for all of them.
std::size_t middle_of(std::size_t begin, std::size_t end) { return begin + (end - begin) / 2; }

}  // namespace

Ride::Ride(const Shape& shape, const TimedPose& from, const PoseTrack::Segment& segment)
    : shape_(shape),
      from_(from),
      span_(segment.duration),
      axis_(segment.axis),
      rate_(segment.angle / span_),
      screw_{from.pose.translation(), segment.way / span_, rate_ * (from.pose.linear() * axis_), extent(shape)} {}

Shape Ride::shape_at(double time) const {
  Eigen::Isometry3d pose = from_.pose;
  pose.translation() += (time - from_.time) * screw_.velocity;
  pose.linear() = pose.linear() * Eigen::AngleAxisd((time - from_.time) * rate_, axis_).toRotationMatrix();
  return placed(shape_, pose);
}

Screw Ride::screw_at(double time) const {
  Screw screw = screw_;
  screw.origin += (time - from_.time) * screw_.velocity;
  return screw;
}

Interval Ride::times() const { return {std::max(0.0, from_.time), from_.time + span_}; }

Ball Ride::ball() const {
  const Eigen::Vector3d half_way = 0.5 * span_ * screw_.velocity;
  return {from_.pose.translation() + half_way, half_way.norm() + screw_.reach};
}

RideTree::RideTree(std::vector<Ride> rides) : rides_(std::move(rides)), balls_(rides_.size()) {
  if (!rides_.empty()) enclose(0, rides_.size());
}

Ball RideTree::enclose(std::size_t begin, std::size_t end) {
  const std::size_t middle = middle_of(begin, end);
  Ball ball = rides_[middle].ball();
  if (begin < middle) ball = around(ball, enclose(begin, middle));
  if (middle + 1 < end) ball = around(ball, enclose(middle + 1, end));
  return balls_[middle] = ball;
}

void RideTree::add_meetings(const Shape& fixed, double distance, const Budget& budget,
                            std::vector<Interval>& times) const {
  add_meetings(0, rides_.size(), fixed, distance, budget, times);
}

void RideTree::add_meetings(std::size_t begin, std::size_t end, const Shape& fixed, double distance,
                            const Budget& budget, std::vector<Interval>& times) const {
  if (begin >= end) return;
  const std::size_t middle = middle_of(begin, end);
  const Ball& all = balls_[middle];
  if (distance_to_ball(fixed, all.middle, all.radius) > distance || budget.exhausted()) return;
  add_meetings(begin, middle, fixed, distance, budget, times);
  const Ride& ride = rides_[middle];
  const Ball ball = ride.ball();
  if (distance_to_ball(fixed, ball.middle, ball.radius) <= distance) {
    const std::vector<Interval> meetings = colliding_parameters(fixed, ride, distance, ride.times());
    times.insert(times.end(), meetings.begin(), meetings.end());
  }
  add_meetings(middle + 1, end, fixed, distance, budget, times);
}

}  // namespace dualarm
