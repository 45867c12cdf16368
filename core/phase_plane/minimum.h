#pragma once

#include "core/model/problem.h"
#include "core/phase_plane/profile.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// A double integrator that may drive and brake everywhere as hard as a system can anywhere in its range, under the
/// same velocity limits. The duration (s) of its fastest motion is a lower bound for every motion of the system between
/// two states; 0 where it knows none. Theory, section 1.4.
class Relaxation {
 public:
  /// For motions from a start to a goal, and between states that are no faster than the faster of them.
  Relaxation(const System& system, JointState start, JointState goal);

  double duration(JointState start, JointState goal) const;

  /// What swinging away and coming back to the same place faster costs at least, s per rad/s of the speed it comes back
  /// with in a direction (+1 or -1).
  double run_up_price(double direction) const;

  /// The same for leaving a place faster in a direction, and coming back to it.
  double overshoot_price(double direction) const;

  /// Speed (rad/s) that a run-up over `room` (rad) gives at most in a direction, and that an overshoot can be stopped
  /// from.
  double fastest_run_up(double direction, double room) const;
  double fastest_overshoot(double direction, double room) const;

 private:
  /// Accelerations, rad/s2; may be infinite.
  struct Drive {
    double drives = 0.0;  ///< of a motion in a direction, along it
    double brakes = 0.0;  ///< of the same motion, against it
  };

  const Drive& along(double direction) const { return direction > 0.0 ? up_ : down_; }
  double limit(double direction) const { return direction > 0.0 ? velocities_.upper : -velocities_.lower; }
  static double way_duration(double distance, double start, double goal, Drive along, Drive against, double limit);

  Drive up_;
  Drive down_;
  Interval velocities_;
};

/// Whether the velocity matters to either end of the admissible accelerations in either direction.
bool depends_on_velocity(const System& system);

/// Whether accelerations of both signs are admissible at standstill everywhere in the range.
bool is_strong(const System& system);

/// Whether a motion of one change of torque, lasting `duration` (s), is proven to be the fastest of all by how far
/// apart changes of torque must be: on a strong system without friction two of them in an optimal motion are at least
/// pi / sqrt(stiffness) apart, so that a shorter motion has one at most, and there is only one such motion.
/// Theory, section 1.4.
bool is_minimum_by_duration(const System& system, double duration);

/// Whether a motion that never turns back, the fastest such from its start to its goal, is proven to be the fastest of
/// all: no run-up by swinging back before the start, and no overshoot beyond the goal, can save the time that it costs.
/// Theory, section 1.4.
bool is_minimum_by_run_up(const System& system, const Profile& profile);

}  // namespace dualarm
