#pragma once

#include <optional>

#include "core/model/budget.h"
#include "core/model/interval_set.h"
#include "core/phase_plane/profile.h"
#include "geometry/interval_list.h"

namespace dualarm {

/// A part of the plane of an arm's own clock and another clock: the own times of an interval with those other times of
/// an interval that differ from them by what an interval says; all s, and the last two may be infinite.
struct Patch {
  Interval own;
  Interval others;
  Interval differences;            ///< own minus other
  double likely_difference = 0.0;  ///< at which a collision is most likely
  const Leg* leg = nullptr;        ///< of the arm during `own`
  double position = 0.0;           ///< rad, of the arm at `time`
  double time = 0.0;               ///< s, of its own clock, inside `own`
};

/// When something that goes by its own clock (another arm, an object on a track) is in the way of an arm.
class Meetings {
 public:
  virtual ~Meetings() = default;

  /// The times (s) of its clock at which it collides with the arm at a position (rad), in any order. Ends may be
  /// infinite.
  virtual IntervalList times_at(double position) const = 0;

  /// A superset of the times at all positions of an interval, which tends to them in the limit of short ones.
  virtual IntervalList times_over(Interval positions) const = 0;

  /// Whether it is proven that nothing collides in a patch. Who can tell only that which `times_over` tells says no.
  virtual bool is_free(const Patch& /*patch*/) const { return false; }
};

/// How a projection is computed.
struct ProjectionRules {
  double longest = 0.0;        ///< s, >= 0, the duration that sets the resolution
  bool stands_at_goal = true;  ///< whether the arm is expected to stay where it arrives
};

/// The differences (s) between an arm's own clock and the other clock with which the two collide: the projection of
/// { (own time, other time) } along the diagonal. The arm stands still before its start and, if so asked, after its
/// arrival. Branch and bound over the arm's path; ends are local extrema polished to rounding, and proven to be the
/// global ones to 1e-4 of `longest`: gaps narrower than twice that may be closed. Nothing if the budget ran out.
/// Theory, section 3.
std::optional<IntervalSet> project(const Meetings& meetings, const Profile& arm, const ProjectionRules& rules,
                                   const Budget& budget);

}  // namespace dualarm
