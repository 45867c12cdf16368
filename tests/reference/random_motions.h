#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "core/model/arm.h"
#include "core/model/problem.h"

namespace dualarm {

/// What makes a random one-arm problem hard.
enum class Family {
  kStrong,              ///< more torque than gravity everywhere, rest to rest
  kWeak,                ///< less torque than gravity somewhere
  kTightRange,          ///< the joint range hardly holds the motion
  kFastLimits,          ///< asymmetric velocity limits that are met, held or not
  kBoundaryVelocities,  ///< the start and the goal move
  kTorqueSpeed,         ///< the line of an electric drive
  kTable,               ///< a bilinear table
  kFriction,            ///< viscous friction
  kMixed                ///< all of it at once
};

inline constexpr Family kEveryFamily[] = {
    Family::kStrong,      Family::kWeak,  Family::kTightRange, Family::kFastLimits, Family::kBoundaryVelocities,
    Family::kTorqueSpeed, Family::kTable, Family::kFriction,   Family::kMixed};

std::string name_of(Family family);

/// Whether the accelerations at the limits depend on the velocity.
bool velocity_matters(const Arm& arm);

struct MotionProblem {
  Arm arm;
  JointState start;
  JointState goal;
};

/// The problem with a number, the same on every machine and in every run. Ends lie in the joint range and within the
/// velocity limits; those at rest can be held there.
MotionProblem random_motion(Family family, std::uint64_t seed);

/// All numbers of a problem, to rebuild it by hand.
std::ostream& operator<<(std::ostream& out, const MotionProblem& problem);

}  // namespace dualarm
