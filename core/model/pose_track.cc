#include "core/model/pose_track.h"

#include <algorithm>
#include <utility>

namespace dualarm {

PoseTrack::PoseTrack(std::vector<TimedPose> poses) {
  std::vector<Segment> segments;
  double travel = 0.0;
  double turn = 0.0;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const Eigen::Isometry3d& from = poses[i].pose;
    const Eigen::Isometry3d& to = poses[i + 1].pose;
    const Eigen::AngleAxisd turned(Eigen::Matrix3d(from.linear().transpose() * to.linear()));
    const Eigen::Vector3d way = to.translation() - from.translation();
    segments.push_back({poses[i + 1].time - poses[i].time, way, turned.axis(), turned.angle(), travel, turn});
    travel += way.norm();
    turn += turned.angle();
  }
  poses_ = std::make_shared<const std::vector<TimedPose>>(std::move(poses));
  segments_ = std::make_shared<const std::vector<Segment>>(std::move(segments));
}

std::size_t PoseTrack::segment_at(double time) const {
  const auto later = std::upper_bound(poses().begin(), poses().end() - 1, time,
                                      [](double value, const TimedPose& pose) { return value < pose.time; });
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(later - poses().begin() - 1, 0));
}

Eigen::Isometry3d PoseTrack::pose_at(double time) const {
  if (time <= begin_time()) return poses().front().pose;
  if (time >= end_time()) return poses().back().pose;
  const std::size_t i = std::min(segment_at(time), segments().size() - 1);
  const Segment& segment = segments()[i];
  const double share = (time - poses()[i].time) / segment.duration;
  Eigen::Isometry3d pose = poses()[i].pose;
  pose.translation() += share * segment.way;
  pose.linear() = pose.linear() * Eigen::AngleAxisd(share * segment.angle, segment.axis).toRotationMatrix();
  return pose;
}

template <typename Rate>
double PoseTrack::largest(Interval time, const Rate& rate) const {
  double found = 0.0;
  const auto first_end = std::lower_bound(poses().begin() + 1, poses().end(), time.lower,
                                          [](const TimedPose& pose, double value) { return pose.time < value; });
  for (auto end = first_end; end < poses().end() && (end - 1)->time <= time.upper; ++end) {
    found = std::max(found, rate(segments()[static_cast<std::size_t>(end - poses().begin() - 1)]));
  }
  return found;
}

double PoseTrack::largest_speed(Interval time) const {
  return largest(time, [](const Segment& segment) { return segment.way.norm() / segment.duration; });
}

double PoseTrack::largest_turning_rate(Interval time) const {
  return largest(time, [](const Segment& segment) { return segment.angle / segment.duration; });
}

double PoseTrack::travel(Interval time) const { return travel_until(time.upper) - travel_until(time.lower); }

double PoseTrack::turn(Interval time) const { return turn_until(time.upper) - turn_until(time.lower); }

double PoseTrack::travel_until(double time) const {
  if (segments().empty() || time <= begin_time()) return 0.0;
  const std::size_t i = std::min(segment_at(time), segments().size() - 1);
  const double share = std::min((time - poses()[i].time) / segments()[i].duration, 1.0);
  return segments()[i].travel_before + share * segments()[i].way.norm();
}

double PoseTrack::turn_until(double time) const {
  if (segments().empty() || time <= begin_time()) return 0.0;
  const std::size_t i = std::min(segment_at(time), segments().size() - 1);
  const double share = std::min((time - poses()[i].time) / segments()[i].duration, 1.0);
  return segments()[i].turn_before + share * segments()[i].angle;
}

}  // namespace dualarm
