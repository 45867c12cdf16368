#pragma once

#include <array>
#include <cstdint>

#include "core/model/problem.h"

namespace dualarm {

/// The dual arm of the worked values (theory, section 4): links of 6 m, bases 8 m apart, 1 kg, 3 kg m2 (39 kg m2 about
/// the joint), the paper's gravity with 9.81 m/s2, |torque| <= 60 N m, |velocity| <= 2 rad/s, range [0, pi]; arms
/// "arm1" at the origin and "arm2" facing it. From rest to rest, angles in degrees; radius and clearance in m.
Problem paper_problem(std::array<double, kArmCount> start_degrees, std::array<double, kArmCount> goal_degrees,
                      double radius = 0.0, double clearance = 0.0);

/// A problem of two planar arms that face each other, reproducible from its seed: lengths, masses, radii, limits,
/// clearance, base distance, placement in the world and its mirror image, all pairs of directions (also an arm that
/// stays), drives that can lift their arm everywhere and some that can not. Start and goal keep the clearance wherever
/// such were found in 200 tries.
Problem random_problem(std::uint64_t seed);

}  // namespace dualarm
