#pragma once

#include <optional>
#include <vector>

#include "core/model/interval_set.h"
#include "core/model/trajectory.h"
#include "core/phase_plane/arc_motion.h"
#include "core/phase_plane/system.h"
#include "geometry/interval_list.h"

namespace dualarm {

/// A stretch of a profile on which it moves in one direction. Times in s on the profile's clock.
struct Leg {
  std::size_t first_arc = 0;  ///< index of its first arc
  std::size_t last_arc = 0;   ///< index of its last arc
  double start_time = 0.0;
  double end_time = 0.0;
  double start = 0.0;  ///< rad
  double goal = 0.0;   ///< rad
};

/// A state and when it is passed, s on the profile's clock.
struct TimedState {
  double time = 0.0;
  JointState state;
};

/// A motion of one degree of freedom on its own clock from 0 to duration(): arcs of extreme acceleration and of
/// constant velocity, joined without gaps, which may turn back at rest. Before 0 it stands at its start and after
/// duration() at its goal, if it is at rest there; otherwise it is not defined outside and answers as if it stood
/// there. Refers to its System, which has to outlive it.
class Profile {
 public:
  /// The motion that stands still at `position`.
  Profile(const System& system, double position) : Profile(system, JointState{position, 0.0}) {}

  /// The motion of no duration in a state.
  Profile(const System& system, JointState state);

  /// Arcs in order of time, each beginning in the state in which the one before ends; their times are filled in here.
  /// Precondition: at least one arc, none without length or change of velocity, none that turns back on the way, no
  /// kHold.
  Profile(const System& system, std::vector<Arc> arcs);

  /// The same motion, prepared for many questions about times.
  Profile asked_often() const;

  double duration() const { return duration_; }        ///< s
  JointState start_state() const { return start_; }    ///< at 0
  JointState goal_state() const { return goal_; }      ///< at duration()
  double start() const { return start_.position; }     ///< rad
  double goal() const { return goal_.position; }       ///< rad
  bool stands_still() const { return arcs_.empty(); }  ///< no time passes, nothing moves

  /// Lowest and highest position on the way, rad.
  Interval extent() const;

  /// The exact motion; times on the own clock. Empty where it stands still.
  const std::vector<Arc>& arcs() const { return arcs_; }

  /// Its stretches of one direction, in order of time. Empty where it stands still.
  const std::vector<Leg>& legs() const { return legs_; }

  /// The end of the admissible accelerations that is the rule of one of arcs(); nothing for a cruise.
  std::optional<Extreme> extreme_on(const Arc& arc) const { return motion_of(arc).extreme(); }

  /// Acceleration (rad/s2) that the rule of one of arcs() gives in a state.
  double acceleration_on(const Arc& arc, JointState state) const;

  /// State at a time of the own clock, to 1e-12; clamped outside [0, duration].
  JointState at(double time) const;

  /// Time (s) on the own clock at which a leg passes a position between its ends (clamped to them), to 1e-12 relative
  /// of the duration.
  double time_at(const Leg& leg, double position) const;

  /// Velocity (rad/s) with which a leg passes a position between its ends (clamped to them).
  double velocity_at(const Leg& leg, double position) const;

  /// A state that is passed near a time (clamped to [0, duration]), and exactly when: cheaper than the state at a time.
  TimedState passed_near(double time) const;

  /// No acceleration (rad/s2) is larger anywhere on the way; infinite where the system knows no bound.
  double largest_acceleration() const;

  /// All times of the own clock, standing before and after included, at which the position lies in the interval.
  /// Infinite ends where the start or the goal does.
  IntervalSet times_in(Interval positions) const;

  /// The same, added to `times` in any order, and they may touch: for those who ask often.
  void add_times_in(Interval positions, IntervalList& times) const;

  /// States of one of arcs() at `count` + 1 evenly spaced times from its start to its end.
  std::vector<JointState> states_along(const Arc& arc, int count) const;

 private:
  const ArcMotion& motion_of(const Arc& arc) const;
  std::size_t arc_at(const Leg& leg, double position) const;

  const System* system_;
  std::vector<Arc> arcs_;
  std::vector<ArcMotion> motions_;  ///< one for each arc
  std::vector<Leg> legs_;
  JointState start_;
  JointState goal_;
  double duration_ = 0.0;
};

/// A motion that begins at a time (s) of the plan's clock.
struct TimedProfile {
  double start_time = 0.0;
  Profile profile;
};

}  // namespace dualarm
