#pragma once

#include <array>
#include <cmath>

#include "core/model/arm.h"
#include "core/verification/peak.h"
#include "core/verification/quintic.h"

namespace dualarm {

/// The torque that a motion needs from the drive: I theta'' + G sin(theta - phi) + b theta'. Theory, section 1.
class JointTorque {
 public:
  /// `arm` with what it carries (loaded_arm).
  explicit JointTorque(const Arm& arm)
      : inertia_(arm.inertia), gravity_(arm.gravity), friction_(arm.viscous_friction) {}

  double inertia() const { return inertia_; }
  double gravity_amplitude() const { return gravity_.amplitude; }
  double gravity_phase() const { return gravity_.phase; }
  double friction() const { return friction_; }

  /// N m, in a state with an acceleration (rad/s2).
  double at(JointState state, double acceleration) const {
    return inertia_ * acceleration + gravity_.amplitude * std::sin(state.position - gravity_.phase) +
           friction_ * state.velocity;
  }

  /// Second derivative with respect to time, N m/s2, at a time of a piece of motion.
  double second_derivative(const Quintic& piece, double time) const;

  /// Upper bound on the magnitude of the third derivative, N m/s3, over a piece of motion.
  double most_third_derivative(const Quintic& piece) const;

  /// How much the last digits of the knots may matter, N m.
  double rounding(const Quintic& piece) const {
    return inertia_ * piece.acceleration_rounding() + friction_ * piece.velocity_rounding();
  }

  /// An interval (N m) that contains the torque over all of a piece of motion: by the Taylor polynomial of degree four
  /// in the middle, the remainder that the bounds on the derivatives leave, and the polynomial's Bernstein
  /// coefficients. Where the torque is constant while inertia and gravity change against each other, it is tight to
  /// rounding and to the fifth power of the piece's length. No tighter than it takes to lie within `enough`.
  Interval over(const Quintic& piece, Interval enough = {0.0, 0.0}) const;

  /// N m, along a piece of motion. The curvature bound is tight on fastest motions, where the torque is constant while
  /// inertia, gravity and friction change against each other: it takes their sum in the middle of an interval, exactly,
  /// and adds the largest change from there by the third derivative.
  Quantity along(const Quintic& piece) const;

 private:
  /// From the derivatives of the position.
  double second_derivative(const std::array<double, 6>& q) const;

  double inertia_;
  GravityTorque gravity_;
  double friction_;
};

}  // namespace dualarm
