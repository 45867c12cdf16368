#pragma once

#include <array>
#include <vector>

#include "core/model/problem.h"
#include "tests/reference/transcription_motion.h"

namespace dualarm {

using Scripts = std::array<Script, kArmCount>;

/// How far two bare links are from each other (m) minus both radii, at joint positions in rad, by exact_distance; where
/// their axes cross, minus the least way that parts them is in place of the distance: continuous, and falling inwards.
double separation(const Problem& problem, std::array<double, kArmCount> positions);

/// What both arms do when they play their scripts.
struct Rehearsal {
  std::array<double, kArmCount> position_miss{};  ///< rad, end minus goal
  std::array<double, kArmCount> velocity_miss{};  ///< rad/s
  std::array<Interval, kArmCount> positions;      ///< rad, what each arm sweeps
  std::vector<double> separations;                ///< m, the smallest in each part of the time
  double torque_shortfall = 0.0;                  ///< N m
};

/// How closely to look.
struct Rehearsing {
  int steps = 10;     ///< of integration, a stretch
  int parts = 40;     ///< of the time, each with its smallest separation
  int nodes = 5;      ///< of each part, besides its ends
  double near = 0.3;  ///< m: below this a smallest separation between nodes is looked for, by Brent's method
};

/// What happens within `duration` (s). For two links in one plane without objects, constant torque limits, motions from
/// rest to rest.
Rehearsal rehearse(const Problem& problem, const Scripts& scripts, double duration, const Rehearsing& how = {});

/// By how much (m) the smallest separation of all falls short of the demanded clearance; <= 0 if it does not.
double clearance_miss(const Problem& problem, const Rehearsal& rehearsal);

}  // namespace dualarm
