#pragma once

#include <vector>

#include "core/model/trajectory.h"

namespace dualarm {

/// The paper's problem without gravity: full torques make parabolas, which knots represent exactly.
Problem weightless_problem(std::array<double, kArmCount> start_degrees, std::array<double, kArmCount> goal_degrees,
                           double radius = 0.0, double clearance = 0.0);

/// Each arm of a weightless problem rests, moves from start to goal with full torque forward and back, and rests until
/// `duration` (s; 0: until both have arrived). Knots at most 0.02 s apart, arcs included. Nobody looks at collisions.
Trajectory parabolic_motion(const Problem& problem, std::array<double, kArmCount> start_times, double duration = 0.0);

/// Both arms rest at their starts for `duration` s, which may be 0.
Trajectory resting_motion(const Problem& problem, double duration);

/// Arm 1 under gravity with its full torque upward from rest for `duration` s, by an ODE in long double; arm 2 rests.
/// The problem's first goal becomes the state that is reached.
Trajectory full_torque_motion(Problem& problem, double duration, double knot_period);

/// What the drive of arm 1 does for a while: all that its limits allow in a sense, or what a constant velocity needs.
enum class Effort { kUpward, kDownward, kSteady };

struct Stretch {
  Effort effort = Effort::kUpward;
  double duration = 0.0;  // s
};

/// Arm 1 (with its gravity, friction and limits of any kind) from its task's start, moving or not, by an ODE in long
/// double; arm 2 rests. Two knots share a time between stretches, and a knot stands wherever the motion crosses a bend
/// of the limits (unless `knots_at_bends` is off). The problem's first goal becomes the state that is reached.
Trajectory driven_motion(Problem& problem, const std::vector<Stretch>& stretches, double knot_period,
                         bool knots_at_bends = true);

}  // namespace dualarm
