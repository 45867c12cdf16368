#pragma once

#include "core/model/arm.h"

namespace dualarm {

/// I theta'' = tau - G sin(theta), |tau| <= T, without a velocity limit, free to turn either way.
inline Arm pendulum(double inertia, double gravity, double torque) {
  Arm arm;
  arm.name = "pendulum";
  arm.length = 1.0;
  arm.inertia = inertia;
  arm.gravity = {gravity, 0.0};
  arm.torque = Interval{-torque, torque};
  arm.joint_range = {-10.0, 10.0};
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  arm.velocity = {-kInfinity, kInfinity};
  return arm;
}

}  // namespace dualarm
