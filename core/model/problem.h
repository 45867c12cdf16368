#pragma once

#include <array>
#include <cstddef>
#include <chrono>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/model/arm.h"
#include "core/model/scene.h"

namespace dualarm {

inline constexpr int kArmCount = 2;

/// Position (rad) and velocity (rad/s) of a joint.
struct JointState {
  double position = 0.0;
  double velocity = 0.0;
  bool operator==(const JointState&) const = default;
};

/// What one arm has to do.
struct Task {
  JointState start;
  JointState goal;
};

/// Which set of the (theta1, theta2) plane counts as forbidden. Theory, section 2.
enum class RegionModel {
  kExact,  ///< where the bodies really come closer than the demanded clearance
  kPaper,  ///< that, and the paper's conservative set R_c [paper, figure 2]
};

/// How a plan came about. Theory, sections 3, 4 and 6.
enum class Method { kSimultaneous, kDelay, kPassage, kStateTime };

struct PlanOptions {
  double clearance = 0.0;  ///< m, >= 0, demanded between all bodies
  std::uint64_t seed = 0;  ///< of the fallback's search
  std::size_t search_memory = std::size_t{32} << 20;  ///< bytes, > 0, that the fallback's tree may take
  RegionModel region_model = RegionModel::kExact;
  std::vector<Method> methods;                                       ///< allowed ones; empty = all
  double knot_period = 0.01;                                         ///< s, > 0, largest spacing while an arm moves
  double max_start_delay = std::numeric_limits<double>::infinity();  ///< s, >= 0

  bool allows(Method method) const;
};

/// A whole planning problem, validated: every number finite and in its range unless said otherwise.
struct Problem {
  std::array<Arm, kArmCount> arms;
  std::vector<Object> objects;
  std::array<Task, kArmCount> tasks;
  PlanOptions options;
};

/// The bodies that move with an arm, in its link frame: the link first, then carried objects in the order of the scene.
std::vector<Body> moving_bodies(const Problem& problem, int arm);

/// The bodies that stand still, in the world.
std::vector<Body> fixed_bodies(const Problem& problem);

/// A body that moves by itself.
struct TrackedBody {
  Body body;                         ///< in its own frame
  const PoseTrack* track = nullptr;  ///< of its frame in the world; belongs to the problem, which outlives this
};

/// The bodies that move by themselves, in the order of the scene. They point into the problem.
std::vector<TrackedBody> tracked_bodies(const Problem& problem);

/// The arm with the inertia and gravity of what it carries added. Theory, section 1.
Arm loaded_arm(const Problem& problem, int arm);

}  // namespace dualarm
