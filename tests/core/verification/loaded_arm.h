#pragma once

#include "core/model/problem.h"

namespace dualarm {

/// An arm that needs torque for its inertia (kg m2), against gravity (N m) and against viscous friction (N m s/rad).
inline Arm arm_with(double inertia, double gravity, double friction) {
  Arm arm;
  arm.inertia = inertia;
  arm.gravity = {gravity, 0.4};
  arm.viscous_friction = friction;
  return arm;
}

}  // namespace dualarm
