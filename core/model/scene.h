#pragma once

#include <Eigen/Geometry>
#include <string>
#include <variant>
#include <vector>

#include "geometry/body.h"

namespace dualarm {

/// Stands still: the pose of the object's frame in the world.
struct FixedPlacement {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};

/// Moves with an arm: the pose of the object's frame in that arm's link frame, and the mass the arm has to carry.
struct AttachedPlacement {
  int arm = 0;  ///< index into Problem::arms
  Eigen::Isometry3d pose_in_link = Eigen::Isometry3d::Identity();
  double mass = 0.0;  ///< kg, >= 0, spread evenly over the shape
};

/// Anything besides the two links: a workpiece, a wall, a load. Spheres are capsules of length zero.
struct Object {
  std::string name;
  Capsule shape;  ///< in the object's own frame
  std::variant<FixedPlacement, AttachedPlacement> placement;
};

}  // namespace dualarm
