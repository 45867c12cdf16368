#pragma once

#include <optional>

#include "core/model/problem.h"

namespace dualarm {

/// The positions (rad) that an arm can visit on its way from start to goal within a duration (s): a superset, inside
/// its joint range, by the double integrator that drives everywhere as hard as the arm can anywhere; the whole range
/// where the arm is in motion at an end.
Interval reachable(const Arm& arm, const Task& task, double duration);

/// The duration (s) below which families of motions through a position are complete (through.h), by how far apart
/// changes of torque have to be in an arm's joint range: pi / sqrt(stiffness) for strong drives without friction and
/// with a torque that does not depend on the velocity; 0 for others; may be infinite. Theory, section 4.
double complete_until(const Arm& arm);

/// An arm that within a duration (s) can do whatever `arm` can, and perhaps more, in the joint range that is reachable
/// until then, and for which complete_until is not 0: with the drive of `arm` itself where that will do; else without
/// friction and with constant torque limits that hold the strongest of the drive's, what friction adds when braking,
/// and a little more than gravity. Nothing where friction has no bound, because velocities have none.
std::optional<Arm> relaxed_arm(const Arm& arm, const Task& task, double duration);

}  // namespace dualarm
