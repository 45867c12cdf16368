#pragma once

#include <numbers>
#include <string>

#include "core/model/torque_limit.h"
#include "geometry/chain.h"
#include "geometry/interval.h"

namespace dualarm {

/// Gravity's torque about the joint that the drive has to hold: amplitude * sin(theta - phase).
struct GravityTorque {
  double amplitude = 0.0;  ///< N m, any sign
  double phase = 0.0;      ///< rad
};

/// One joint, one link: everything the planner knows about an arm. Theory, section 1 [paper, eqs. 1-4].
struct Arm {
  std::string name;
  Base base;
  double length = 0.0;                             ///< m, > 0, from the joint to the tip
  double radius = 0.0;                             ///< m, >= 0, of the link's capsule
  Interval joint_range = {0.0, std::numbers::pi};  ///< rad
  double inertia = 0.0;                            ///< kg m2 about the joint, > 0, without carried objects
  GravityTorque gravity;                           ///< of the arm without carried objects
  double payload_gravity = 0.0;                    ///< m/s2, strength of the field that acts on carried objects
  double payload_gravity_phase = 0.0;              ///< rad, joint position at which a point on the link's axis hangs
  double viscous_friction = 0.0;                   ///< N m s, >= 0: torque lost per joint velocity
  TorqueLimit torque;                              ///< of the drive, N m
  Interval velocity = {0.0, 0.0};                  ///< rad/s, lower < 0 < upper; ends may be infinite
};

/// Gravity as the paper writes it: 1/2 m g l sin(theta), hanging at theta = 0 [paper, eq. 1].
GravityTorque paper_gravity(double mass, double length, double gravity = 9.81);

/// Gravity of a field (m/s2, in the plane of motion, world axes) on a mass whose centre lies on the link's axis at
/// `centre_of_mass` m from the joint of `base`.
GravityTorque field_gravity(double mass, double centre_of_mass, Eigen::Vector2d field, const Base& base);

}  // namespace dualarm
