#pragma once

#include <vector>

#include "core/coordination/advance.h"
#include "core/model/budget.h"
#include "core/model/problem.h"

namespace dualarm {

/// A ball that contains something on all of its way.
struct Ball {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< m
  double radius = 0.0;                               ///< m
};

/// A body on its way from one pose of its track to the next.
class Ride final : public Wanderer {
 public:
  Ride(const Shape& shape, const TimedPose& from, const PoseTrack::Segment& segment);

  /// As PoseTrack::pose_at, for times (s) of this stretch of the track.
  Shape shape_at(double time) const override;
  Screw screw_at(double time) const override;

  Interval times() const;  ///< s, of the plan
  Ball ball() const;

 private:
  Shape shape_;
  TimedPose from_;
  double span_;  ///< s
  Eigen::Vector3d axis_;
  double rate_;  ///< rad/s
  Screw screw_;  ///< at the first pose
};

/// Rides that follow each other, in a tree of balls: those that come near are found without looking at all.
class RideTree {
 public:
  explicit RideTree(std::vector<Ride> rides);

  bool empty() const { return rides_.empty(); }

  /// The times (s) at which a ride comes closer than `distance` (m) to a fixed shape are added to `times`; not all of
  /// them if the budget runs out.
  void add_meetings(const Shape& fixed, double distance, const Budget& budget, std::vector<Interval>& times) const;

 private:
  void add_meetings(std::size_t begin, std::size_t end, const Shape& fixed, double distance, const Budget& budget,
                    std::vector<Interval>& times) const;
  Ball enclose(std::size_t begin, std::size_t end);

  std::vector<Ride> rides_;
  std::vector<Ball> balls_;  ///< of the rides from begin to end, at the place of the middle one
};

}  // namespace dualarm
