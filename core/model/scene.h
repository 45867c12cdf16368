#pragma once

#include <Eigen/Geometry>
#include <string>
#include <variant>
#include <vector>

#include "core/model/pose_track.h"
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

/// Moves by itself: the poses of the object's frame in the world over the time of the plan.
struct MovingPlacement {
  PoseTrack track;
};

/// Anything besides the two links: a workpiece, a wall, a load, a door. Spheres are capsules of length zero.
struct Object {
  std::string name;
  Shape shape;  ///< in the object's own frame
  std::variant<FixedPlacement, AttachedPlacement, MovingPlacement> placement;
};

}  // namespace dualarm
