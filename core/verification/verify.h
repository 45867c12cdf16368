#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/model/budget.h"
#include "core/model/problem.h"
#include "core/model/trajectory.h"

namespace dualarm {

/// A claim of a trajectory that does not hold.
enum class ViolationKind {
  kArm,               ///< trajectories are not one for each arm of the problem, in its order
  kKnotOrder,         ///< fewer than two knots, times that decrease, nearly meet or are not finite, arms with two spans
  kContinuity,        ///< position or velocity jumps between knots that share a time, all jumps together
  kEndState,          ///< first or last knot is not the task's start or goal
  kJointRange,        ///< position leaves the joint range
  kVelocity,          ///< velocity leaves its limits
  kTorque,            ///< the torque that the motion needs leaves its limits
  kTorqueColumn,      ///< the torque that is written is not the one that the motion needs
  kArc,               ///< arcs and knots tell different motions
  kClearance,         ///< two bodies come closer than demanded
  kClearanceUnknown,  ///< the proof did not end, of the clearance or (out of budget) of a limit: neither kept nor
                      ///< broken
};

struct Violation {
  ViolationKind kind = ViolationKind::kArm;
  std::string explanation;  ///< a sentence with names, times and numbers
  std::string arm;          ///< empty where both arms or none are meant
  double time = 0.0;        ///< s; behind the motion's end where an object comes to an arm that stands at its goal
  double value = 0.0;       ///< what was found, in the unit of the claim
  double limit = 0.0;       ///< what was demanded
};

/// How much of a limit is used at most: 1 is at the limit. Proven upper bounds along the whole interpolant.
struct Utilisation {
  double value = 0.0;
  std::string arm;
  double time = 0.0;  ///< s
};

/// The closest encounter of the whole motion, and of the time after it in which objects still move.
struct ClosestApproach {
  double time = 0.0;  ///< s
  std::string first_body;
  std::string second_body;
  Eigen::Vector3d first_point = Eigen::Vector3d::Zero();   ///< m, world
  Eigen::Vector3d second_point = Eigen::Vector3d::Zero();  ///< m, world
};

struct Verification {
  bool collision_free = false;  ///< proven over all of the time, with the demanded clearance
  double min_clearance = 0.0;   ///< m, proven lower bound of the distance of all pairs of bodies (if collision_free)
  std::optional<ClosestApproach> closest;
  double max_position_error = 0.0;  ///< rad, bound on how far a drive that passes through the knots and applies the
                                    ///< written torque linearly in between can be from the interpolant
  Utilisation torque;
  Utilisation velocity;
  Utilisation range;
  int distance_query_count = 0;
  std::vector<Violation> violations;

  bool holds() const { return collision_free && violations.empty(); }
};

/// Proves or refutes a trajectory for a problem, continuously in time, from nothing but the two of them: end states
/// (unless `check_end_states` is off), joint range, velocity, torque and written torque along the interpolant, and the
/// clearance of all pairs of bodies, of any shape, by FCL distances and motion bounds. All of it holds from time 0 to
/// the end of the plan and says nothing about later: then the arms stand still, and objects that move by themselves may
/// still come. Theory, section 5. Never throws on bad trajectories: they come back as violations. Stops when the budget
/// is exhausted, with kClearanceUnknown.
Verification verify(const Problem& problem, const Trajectory& trajectory, const Budget& budget,
                    bool check_end_states = true);

}  // namespace dualarm
