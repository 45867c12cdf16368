#pragma once

#include <Eigen/Geometry>

#include "geometry/body.h"

namespace dualarm {

/// Sense in which a positive joint change turns the link, seen from above (+z towards the viewer).
enum class Rotation { kCounterclockwise, kClockwise };

/// Where an arm's joint stands. Its axis is the world's z; the arm moves in the plane z = position.z().
struct Base {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m
  double heading = 0.0;                                ///< rad, world direction of the link at joint position 0
  Rotation rotation = Rotation::kCounterclockwise;

  /// +1 for counterclockwise, -1 for clockwise.
  double sense() const { return rotation == Rotation::kCounterclockwise ? 1.0 : -1.0; }
};

/// Pose of the link frame in the world at a joint position (rad): origin at the joint, x along the link, z the world's
/// z whatever the sense of rotation.
Eigen::Isometry3d link_pose(const Base& base, double joint_position);

/// The shape moved by a pose, of the same kind.
Capsule placed(const Capsule& capsule, const Eigen::Isometry3d& pose);
Shape placed(const Shape& shape, const Eigen::Isometry3d& pose);

}  // namespace dualarm
