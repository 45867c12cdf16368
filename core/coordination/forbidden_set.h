#pragma once

#include <optional>
#include <vector>

#include "core/model/interval_set.h"
#include "core/model/problem.h"
#include "geometry/lens.h"

namespace dualarm {

/// The set of joint positions (theta1, theta2), rad, at which the two arms with all they carry come closer than a
/// clearance, in closed form for bodies whose axes are parallel to the plane of motion (planes may differ in height).
/// With RegionModel::kPaper the paper's conservative set R_c is added. Theory, section 2 [paper, figure 2].
class ForbiddenSet {
 public:
  /// `clearance` (m, >= 0) between the surfaces of the bodies.
  ForbiddenSet(const Problem& problem, double clearance);

  /// The forbidden theta2 in `window` at one theta1.
  IntervalSet slice(double theta1, Interval window) const;

  /// A superset of the slices at all theta1 of an interval; equal to the slice in the limit of short ones.
  IntervalSet slice_over(Interval theta1, Interval window) const;

  bool contains(double theta1, double theta2) const;

 private:
  struct Pair {
    Segment of_first;   ///< in the link frame of arm 1, m
    Segment of_second;  ///< in the turning frame of arm 2 (mirrored if it turns clockwise), m
    double distance;    ///< m, in the plane, below which the pair collides
    double reach;       ///< m, of of_first from the joint of arm 1
  };

  IntervalSet slice(double theta1, double spread, Interval window) const;
  Segment seen_by_second(const Segment& of_first, double theta1) const;
  Interval paper_slice(Interval theta1) const;

  Base first_base_;
  Base second_base_;
  std::vector<Pair> pairs_;
  bool add_paper_set_;
  double first_length_;
  double second_length_;
};

/// The positions (rad) in `window` of one arm at which what moves with it comes closer than `clearance` (m) to a body
/// that stands still, of capsules. Theory, section 2.
IntervalSet blocked_positions(const Base& base, const Shape& moving, const Shape& fixed, double clearance,
                              Interval window);

}  // namespace dualarm
