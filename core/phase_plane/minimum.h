#pragma once

#include "core/model/problem.h"
#include "core/phase_plane/profile.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// Duration (s) of the fastest motion of a double integrator that may use the best accelerations of the range
/// everywhere, under the same velocity limits: a lower bound for every motion between the states. 0 where it knows
/// none.
class Relaxation {
 public:
  explicit Relaxation(const System& system)
      : accelerations_(system.acceleration_bounds()), velocities_(system.velocity()) {}

  double duration(JointState start, JointState goal) const;

 private:
  Interval accelerations_;
  Interval velocities_;
};

/// Whether accelerations of both signs are admissible everywhere in the range, at any velocity that is.
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
