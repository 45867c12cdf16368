#include "core/verification/carried_body.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/verification/tolerances.h"
#include "geometry/motion_bound.h"
#include "geometry/support.h"

namespace dualarm {
namespace {

double middle_of(Interval time) { return 0.5 * (time.lower + time.upper); }

CarriedBody on_joint(Body body, const CarryingJoint& joint) {
  const double its_reach = reach(body.shape);
  const double its_extent = extent(body.shape);
  return {std::move(body), joint, its_reach, its_extent};
}

CarriedBody on_track(const TrackedBody& tracked) {
  const double its_extent = extent(tracked.body.shape);
  return {tracked.body, tracked.track, its_extent, its_extent};
}

CarriedBody on_ground(Body body) {
  const double radius = bounding_radius(body.shape);
  return {std::move(body), std::monostate(), radius, radius};
}

/// Times of poses inside of an interval: from the first one to behind the last one.
auto corners_inside(const PoseTrack& track, Interval time) {
  const std::vector<TimedPose>& poses = track.poses();
  const auto first = std::upper_bound(poses.begin(), poses.end(), time.lower,
                                      [](double value, const TimedPose& pose) { return value < pose.time; });
  const auto end = std::lower_bound(first, poses.end(), time.upper,
                                    [](const TimedPose& pose, double value) { return pose.time < value; });
  return std::pair(first, end);
}

struct ShapeAt {
  const Shape& shape;
  double time;

  Shape operator()(std::monostate) const { return shape; }
  Shape operator()(const CarryingJoint& joint) const {
    return placed(shape, link_pose(joint.base, joint.motion->state(time).position));
  }
  Shape operator()(const PoseTrack* track) const { return placed(shape, track->pose_at(time)); }
};

struct WayBetween {
  const CarriedBody& body;
  Interval time;

  double operator()(std::monostate) const { return 0.0; }
  double operator()(const CarryingJoint& joint) const { return body.reach * joint.motion->travel(time); }
  double operator()(const PoseTrack* track) const { return track->travel(time) + body.extent * track->turn(time); }
};

struct TurningAt {
  const CarriedBody& body;
  Interval time;

  TurningBody operator()(std::monostate) const {
    TurningBody still;
    still.shape = body.body.shape;
    still.origin = centre(still.shape);
    still.reach = body.reach;
    still.extent = body.extent;
    return still;
  }

  TurningBody operator()(const CarryingJoint& joint) const {
    const Interpolant::During during = joint.motion->during(time);
    return {placed(body.body.shape, link_pose(joint.base, during.in_the_middle.position)),
            joint.base.position,
            Eigen::Vector3d::Zero(),
            Eigen::Vector3d::UnitZ(),
            joint.base.sense() * during.in_the_middle.velocity,
            during.most.speed,
            during.most.acceleration,
            during.farthest,
            body.reach,
            body.extent,
            body.reach * during.farthest};
  }

  TurningBody operator()(const PoseTrack* track) const {
    const double middle = middle_of(time);
    const Eigen::Isometry3d pose = track->pose_at(middle);
    TurningBody moving;
    moving.shape = placed(body.body.shape, pose);
    moving.origin = pose.translation();
    moving.reach = body.reach;
    moving.extent = body.extent;
    moving.farthest_way = farthest_way(body, time);
    if (middle <= track->begin_time() || middle >= track->end_time()) return moving;
    const auto to = corners_inside(*track, {middle, track->end_time()}).first;
    const auto& segment = track->segments()[static_cast<std::size_t>(to - track->poses().begin()) - 1];
    moving.velocity = segment.way / segment.duration;
    moving.axis = (to - 1)->pose.linear() * segment.axis;
    moving.rate = segment.angle / segment.duration;
    moving.most_rate = std::abs(moving.rate);
    moving.most_turn = moving.most_rate * 0.5 * time.length();
    return moving;
  }
};

const PoseTrack* track_of(const CarriedBody& body) {
  const auto* track = std::get_if<const PoseTrack*>(&body.carrier);
  return track != nullptr ? *track : nullptr;
}

}  // namespace

CarriedBodies carried_bodies(const Problem& problem, const std::array<Interpolant, kArmCount>& motions) {
  CarriedBodies bodies;
  for (int arm = 0; arm < kArmCount; ++arm) {
    for (Body& body : moving_bodies(problem, arm)) {
      bodies.moving[arm].push_back(on_joint(std::move(body), {problem.arms[arm].base, &motions[arm]}));
    }
  }
  for (Body& body : fixed_bodies(problem)) bodies.fixed.push_back(on_ground(std::move(body)));
  for (const TrackedBody& tracked : tracked_bodies(problem)) bodies.tracked.push_back(on_track(tracked));
  return bodies;
}

Shape shape_at(const CarriedBody& body, double time) {
  return std::visit(ShapeAt{body.body.shape, time}, body.carrier);
}

double farthest_way(const CarriedBody& body, Interval time) {
  const double middle = middle_of(time);
  return std::max(std::visit(WayBetween{body, {time.lower, middle}}, body.carrier),
                  std::visit(WayBetween{body, {middle, time.upper}}, body.carrier));
}

bool has_corner_inside(const CarriedBody& body, Interval time) {
  const PoseTrack* track = track_of(body);
  if (track == nullptr) return false;
  const auto [first, end] = corners_inside(*track, time);
  return first != end;
}

double cut_of(const CarriedBody& body, Interval time) {
  const PoseTrack* track = track_of(body);
  if (track == nullptr) return middle_of(time);
  const auto [first, end] = corners_inside(*track, time);
  return first != end ? first[(end - first) / 2].time : middle_of(time);
}

double last_corner(const std::vector<CarriedBody>& bodies) {
  double last = -std::numeric_limits<double>::infinity();
  for (const CarriedBody& body : bodies) {
    if (const PoseTrack* track = track_of(body)) last = std::max(last, track->end_time());
  }
  return last;
}

bool stands_after(const CarriedBody& body, double time) {
  const auto* joint = std::get_if<CarryingJoint>(&body.carrier);
  return joint != nullptr && std::abs(joint->motion->state(time).velocity) <= kStateTolerance;
}

TurningBody turning_body(const CarriedBody& body, Interval time) {
  return std::visit(TurningAt{body, time}, body.carrier);
}

}  // namespace dualarm
