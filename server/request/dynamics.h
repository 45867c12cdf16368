#pragma once

#include "core/model/arm.h"
#include "server/request/field.h"
#include "server/wire.h"

namespace dualarm {

/// The part of an Arm that its Dynamics message tells; units as in Arm.
struct Dynamics {
  double inertia = 0.0;
  GravityTorque gravity;
  double payload_gravity = 0.0;
  double payload_gravity_phase = 0.0;
  double viscous_friction = 0.0;
};

/// Needs the length and the base of the arm: mass sits at the tip, and a field is given in world axes. What is wrong
/// is noted on `field`.
Dynamics read_dynamics(const wire::Dynamics& message, const Field& field, const Arm& arm);

}  // namespace dualarm
