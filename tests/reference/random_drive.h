#pragma once

#include <cstdint>

#include "core/model/arm.h"
#include "core/model/problem.h"

namespace dualarm {

/// Where an arm got to, and when.
struct Drive {
  JointState end;
  double duration = 0.0;  ///< s
};

/// Drives an arm from `start` by a few arcs of random lengths under nearly full torques, some of some other share, some
/// at constant velocity, and stops (in time, not at rest) before the joint range or a velocity limit is broken. Every
/// limit is kept by a hair, so that the end is inside what can be reached. No faster motion may be called impossible.
Drive drive_at_random(const Arm& arm, JointState start, std::uint64_t seed);

}  // namespace dualarm
