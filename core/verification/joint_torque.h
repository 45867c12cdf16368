#pragma once

#include "core/model/arm.h"
#include "core/verification/interpolant.h"
#include "core/verification/peak.h"

namespace dualarm {

/// The torque that a motion needs from the drive: I theta'' + G sin(theta - phi). Theory, section 1.
class JointTorque {
 public:
  /// `arm` with what it carries (loaded_arm).
  explicit JointTorque(const Arm& arm) : inertia_(arm.inertia), gravity_(arm.gravity) {}

  double inertia() const { return inertia_; }
  double gravity_amplitude() const { return gravity_.amplitude; }

  /// N m, at a position (rad) with an acceleration (rad/s2).
  double at(double position, double acceleration) const;

  /// N m, along a piece of motion. The curvature bound is tight on fastest motions, where the torque is constant while
  /// inertia and gravity change against each other: it takes their sum in the middle of an interval, exactly, and adds
  /// the largest change from there by the third derivative.
  Quantity along(const Quintic& piece) const;

 private:
  double inertia_;
  GravityTorque gravity_;
};

}  // namespace dualarm
