#pragma once

#include <optional>

#include "core/model/problem.h"
#include "tests/reference/own_equation.h"

namespace dualarm {

/// Least time (s) of a motion that never turns back between two states, with velocities along the motion or zero, on a
/// mesh of `cells` intervals, finer towards the ends. Nothing if there is none on the mesh. The error falls with the
/// square of the cells.
std::optional<double> sweep_time(const Arm& arm, JointState from, JointState to, int cells);

/// Where the arm comes to rest from a moving state under full braking, and when.
struct Stop {
  double position = 0.0;  ///< rad
  double time = 0.0;      ///< s, > 0
};

/// The stop of a moving arm under full braking; with `backwards`, where and how long before the state full drive began
/// at rest. Nothing if the arm leaves the joint range or the velocity limits first.
std::optional<Stop> full_stop(const Arm& arm, JointState state, bool backwards);

}  // namespace dualarm
