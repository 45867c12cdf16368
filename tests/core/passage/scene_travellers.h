#pragma once

#include "core/passage/gate_bound.h"
#include "core/systems/single_joint_arm.h"

namespace dualarm {

/// Both arms of a problem with their fastest motions. Neither copied nor moved: travellers refer to the systems.
struct SceneTravellers {
  explicit SceneTravellers(const Problem& problem);
  SceneTravellers(const SceneTravellers&) = delete;
  SceneTravellers& operator=(const SceneTravellers&) = delete;

  std::array<SingleJointArm, kArmCount> systems;
  Travellers travellers;
};

inline double in_radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

}  // namespace dualarm
