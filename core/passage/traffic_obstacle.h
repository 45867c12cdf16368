#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/coordination/traffic.h"
#include "core/model/problem.h"
#include "geometry/interval.h"

namespace dualarm {

/// A point of the plane of an arm's position and the time of the plan.
struct Meeting {
  double position = 0.0;  ///< rad
  double time = 0.0;      ///< s
};

/// The set of all meetings of an arm with one object that moves by itself and does not turn: slices through time, and,
/// of what is upright, through positions. They are exact, so that slices which cross each other are connected in it.
/// The problem outlives this.
class TrafficObstacle {
 public:
  TrafficObstacle(const Problem& problem, int arm, const TrackedBody& object, double clearance, const Budget& budget);

  /// The times (s) of meetings at a position (rad).
  IntervalList times_at(double position) const { return traffic_.times_at(position); }

  /// Follows slices that cross each other from a meeting on: through time to its end in the direction `through_time`
  /// (-1 or 1), from there through positions to their end in the direction `through_positions`, and so on, until
  /// `done` says so of a meeting or nothing moves any more. The last meeting; inside of the set.
  Meeting follow(Meeting from, int through_time, int through_positions,
                 const std::function<bool(const Meeting&)>& done) const;

 private:
  std::optional<Interval> times_around(const Meeting& meeting) const;
  std::optional<Interval> positions_around(const Meeting& meeting) const;

  Base base_;
  Interval range_;
  double clearance_;
  std::vector<Body> upright_;  ///< what of the arm is sliced through positions
  TrackedBody object_;
  Traffic traffic_;
};

}  // namespace dualarm
