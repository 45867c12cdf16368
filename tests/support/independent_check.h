#pragma once

#include <string>
#include <vector>

#include "core/model/trajectory.h"

namespace dualarm {

/// What is wrong with a trajectory, one sentence each; empty if nothing is. Shares nothing with core/verification:
/// samples instead of bounds, an ODE instead of the interpolant's derivatives, own kinematics and distances.
///
/// It starts from the knots' states, applies the written torques (cubic in time between knots, never across a switch or
/// a bend of the limits), integrates the equation of motion with gravity and friction (Boost.Odeint) and compares with
/// the knots that follow, to 1e-6 rad and rad/s; it holds torques (at knots and in between) against limits of its own
/// reckoning, positions and velocities against limits and end states, and measures all pairs of bodies, of any shape
/// and also those that move by themselves, at 10,000 instants (sampled_approach).
std::vector<std::string> independent_check(const Problem& problem, const Trajectory& trajectory);

}  // namespace dualarm
