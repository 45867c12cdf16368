#pragma once

#include <string>

#include "core/model/trajectory.h"

namespace dualarm {

/// The closest that two bodies come at the instants that were looked at.
struct SampledApproach {
  double distance = 0.0;  // m, as exact_distance says; infinite if there is no pair
  double time = 0.0;      // s
  std::string first_body;
  std::string second_body;
};

/// The closest approach of all pairs of bodies that may meet (both arms with what they carry, each of them and what
/// stands or moves by itself) at `count` instants from 0 to the end of the plan; and at as many from there to the
/// end of the last track, for arms that rest at their goals and what moves by itself. Shares nothing with
/// core/verification: quintics by Hermite's basis, tracks by quaternions, own kinematics, exact_distance. A pair is not
/// measured where, since it was measured last, its bodies can not have come closer than the closest so far.
/// Precondition: knots of both arms in order, at least two of each.
SampledApproach sampled_approach(const Problem& problem, const Trajectory& trajectory, int count);

}  // namespace dualarm
