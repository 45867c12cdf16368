#pragma once

#include <span>

#include "core/model/problem.h"
#include "geometry/interval_list.h"
#include "geometry/lens.h"

namespace dualarm {

/// A joint on its way, near a state: the position and velocity there, and what its acceleration never exceeds.
struct Course {
  double position = 0.0;              ///< rad
  double velocity = 0.0;              ///< rad/s
  double largest_acceleration = 0.0;  ///< rad/s2, >= 0
};

/// Times on both own clocks, s since a state of each joint.
struct TimePair {
  double first = 0.0;
  double second = 0.0;
};

/// Two upright bodies, each turning with a joint, of which everything is asked in the plane.
class FlatPair {
 public:
  /// Outlines (m) in the link frames of the arms on the two bases; the pair collides below `distance` (m).
  FlatPair(const Base& first_base, const Outline& first, const Base& second_base, const Outline& second,
           double distance);

  /// The theta2 in `window` at which the pair collides at one theta1, all rad; with `spread` (rad, >= 0) a superset of
  /// those at all theta1 that are no farther away. In closed form.
  IntervalList slice(double theta1, double spread, Interval window) const;

  /// Whether both joints, each from a state on, are proven not to collide at any times in the convex hull of `times`. A
  /// proof to second order: at nearest points it errs with the square of the times. Theory, section 3.
  bool stays_apart(const Course& first, const Course& second, std::span<const TimePair> times) const;

 private:
  Figure first_at(double theta1) const;

  Figure first_;           ///< around its joint, in the frame in which the second joint turns counterclockwise
  double first_sense_;     ///< in that frame
  double first_heading_;   ///< rad, in that frame, at theta1 = 0
  double first_reach_;     ///< m
  Eigen::Vector2d joint_;  ///< m, of the first body, in that frame
  Spinner second_;
  double distance_;  ///< m
};

}  // namespace dualarm
