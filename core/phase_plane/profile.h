#pragma once

#include <vector>

#include "core/model/interval_set.h"
#include "core/model/trajectory.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// A monotone motion of one degree of freedom from rest to rest, on its own clock from 0 to duration(): arcs of extreme
/// acceleration and of constant velocity, joined without gaps. Before 0 it stands at its start, after duration() at its
/// goal. Refers to its System, which has to outlive it.
class Profile {
 public:
  /// The motion that stands still at `position`.
  Profile(const System& system, double position);

  /// Arcs in order of time, each beginning in the state in which the one before ends; their times are filled in here,
  /// by quadrature. Precondition: at least one arc, none of zero length, all in one direction, no kHold.
  Profile(const System& system, std::vector<Arc> arcs);

  double duration() const { return duration_; }  ///< s
  double start() const { return start_; }        ///< rad
  double goal() const { return goal_; }          ///< rad

  /// +1 rising, -1 falling, 0 standing still.
  int direction() const;

  /// The exact motion; times on the own clock. Empty where it stands still.
  const std::vector<Arc>& arcs() const { return arcs_; }

  /// Acceleration (rad/s2) that an arc's rule gives at a position.
  double acceleration_on(const Arc& arc, double position) const;

  /// State at a time of the own clock, to 1e-12; clamped outside [0, duration].
  JointState at(double time) const;

  /// Time (s) on the own clock at which the motion passes a position between start and goal (clamped to them), by
  /// adaptive quadrature, to 1e-12 relative of the duration. 0 where it stands still.
  double time_at(double position) const;

  /// All times of the own clock, clamped motion included, at which the position lies in the interval. Infinite ends
  /// where the start or the goal does.
  IntervalSet times_in(Interval positions) const;

  /// States of an arc at `count` + 1 evenly spaced times from its start to its end.
  std::vector<JointState> states_along(const Arc& arc, int count) const;

 private:
  const System* system_;
  std::vector<Arc> arcs_;
  double start_ = 0.0;
  double goal_ = 0.0;
  double duration_ = 0.0;
};

/// A motion that begins at a time (s) of the plan's clock.
struct TimedProfile {
  double start_time = 0.0;
  Profile profile;
};

}  // namespace dualarm
