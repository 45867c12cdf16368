#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "geometry/interval.h"

namespace dualarm {

/// One point of a PoseTrack.
struct TimedPose {
  double time = 0.0;                                       ///< s since the start of the plan
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< in the world
};

/// How an object moves by itself: between two poses its origin moves on a straight line at constant speed and its frame
/// turns at a constant rate about a fixed axis, the shorter way round; before the first and after the last it stands
/// still. Half a turn between two poses has no shorter way: one of both is taken.
class PoseTrack {
 public:
  /// Stands still at the world's origin.
  PoseTrack() : PoseTrack(std::vector<TimedPose>{TimedPose{}}) {}

  /// At least one pose, with strictly increasing finite times; anything else is undefined.
  explicit PoseTrack(std::vector<TimedPose> poses);

  Eigen::Isometry3d pose_at(double time) const;

  double begin_time() const { return poses().front().time; }  ///< s, of the first pose
  double end_time() const { return poses().back().time; }     ///< s, of the last pose
  const std::vector<TimedPose>& poses() const { return *poses_; }

  /// From one pose to the next.
  struct Segment {
    double duration = 0.0;                            ///< s, > 0
    Eigen::Vector3d way = Eigen::Vector3d::Zero();    ///< m
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< unit, in the frame of the first pose
    double angle = 0.0;                               ///< rad, 0 to pi
    double travel_before = 0.0;                       ///< m, from the start of the track
    double turn_before = 0.0;                         ///< rad, from the start of the track
  };

  /// One less than poses().
  const std::vector<Segment>& segments() const { return *segments_; }

  /// Largest speed of the origin (m/s) and largest turning rate (rad/s) at any time of an interval (s), which may
  /// reach beyond the track; at a corner that of both sides counts.
  double largest_speed(Interval time) const;
  double largest_turning_rate(Interval time) const;

  /// What the origin travels (m) and what the frame turns (rad) during an interval, each bend and turn back counted.
  /// No point farther than `e` from the origin moves by more than travel + e * turn.
  double travel(Interval time) const;
  double turn(Interval time) const;

 private:
  template <typename Rate>
  double largest(Interval time, const Rate& rate) const;

  /// The segment that is under way at a time inside the track, the later one at a corner.
  std::size_t segment_at(double time) const;
  double travel_until(double time) const;
  double turn_until(double time) const;

  // Shared by copies: scenes are copied often, and tracks may have thousands of poses.
  std::shared_ptr<const std::vector<TimedPose>> poses_;
  std::shared_ptr<const std::vector<Segment>> segments_;
};

}  // namespace dualarm
