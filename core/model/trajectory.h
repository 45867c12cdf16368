#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/model/problem.h"

namespace dualarm {

/// What an arm does during an arc: full torque forward, full torque backward, constant velocity, or rest.
enum class ArcKind { kAccelerate, kBrake, kCruise, kHold };

/// A piece of the exact motion under one rule of torque. Times in s from the start of the plan.
struct Arc {
  ArcKind kind = ArcKind::kHold;
  double start_time = 0.0;
  double end_time = 0.0;
  JointState start;
  JointState end;
};

/// The sense in which an arc moves, 1 or -1: its velocities tell it, also where positions are too coarse.
inline double direction_of(const Arc& arc) {
  const double velocities = arc.start.velocity + arc.end.velocity;
  return (velocities != 0.0 ? velocities : arc.end.position - arc.start.position) < 0.0 ? -1.0 : 1.0;
}

/// One instant of what a controller plays. Between consecutive knots the motion is the quintic with the position,
/// velocity and acceleration of both. Two knots may share a time: there the torque switches, so that acceleration and
/// torque jump while position and velocity agree.
struct Knot {
  double time = 0.0;          ///< s from the start of the plan
  double position = 0.0;      ///< rad
  double velocity = 0.0;      ///< rad/s
  double acceleration = 0.0;  ///< rad/s2
  double torque = 0.0;        ///< N m, of the drive
};

/// One arm's share of a plan, exactly as it is sent.
struct ArmTrajectory {
  std::string arm;
  double start_time = 0.0;  ///< s, when the arm first moves
  double duration = 0.0;    ///< s, from first moving to its last rest
  std::vector<Arc> arcs;
  std::vector<Knot> knots;  ///< from 0 to the duration of the plan
};

using Trajectory = std::array<ArmTrajectory, kArmCount>;

}  // namespace dualarm
