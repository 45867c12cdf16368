#pragma once

#include <optional>

#include "core/coordination/forbidden_set.h"
#include "core/model/problem.h"

namespace dualarm {

/// A line of the plane of the joint positions on which one arm stands still, and a forbidden stretch of it.
struct Slice {
  int pinned_arm = 0;     ///< index of the arm that stands still
  double position = 0.0;  ///< rad, of that arm
  Interval forbidden;     ///< rad, of the other arm

  bool operator==(const Slice&) const = default;
};

/// Whether two slices, one of either arm, have a point in common.
bool cross(const Slice& first, const Slice& second);

/// The exact forbidden set (RegionModel::kExact, whatever the problem asks for) in the rectangle of the joint ranges,
/// sliced along both axes in closed form: what lies on a slice is proven to be forbidden. Carried objects that lean are
/// left out, since their slices are supersets: bounds are true without them.
class ForbiddenPlane {
 public:
  /// `clearance` (m, >= 0) between the surfaces of the bodies.
  ForbiddenPlane(const Problem& problem, double clearance);

  Interval range(int arm) const { return ranges_[arm]; }

  /// All forbidden positions of the other arm, in its range, with one arm at a position.
  IntervalSet slice(int pinned_arm, double position) const;

  /// The forbidden stretch of that slice that contains `through`, a position of the other arm.
  std::optional<Slice> slice_through(int pinned_arm, double position, double through) const;

 private:
  std::array<Interval, kArmCount> ranges_;
  std::array<ForbiddenSet, kArmCount> sets_;  ///< by pinned arm
};

}  // namespace dualarm
