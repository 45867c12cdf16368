#pragma once

#include <Eigen/Geometry>
#include <string>
#include <variant>

namespace dualarm {

/// All points within `radius` of the segment from `start` to `end`. Start equal to end is a sphere; radius 0 is a
/// segment. Metres, in whatever frame the owner says.
struct Capsule {
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  Eigen::Vector3d end = Eigen::Vector3d::Zero();
  double radius = 0.0;  ///< m, >= 0
};

/// A cuboid centred at the origin of `pose` with its edges along the axes of `pose`. Any of its sizes may be 0: then it
/// is a plate, a segment or a point.
struct Box {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  Eigen::Vector3d half_extents = Eigen::Vector3d::Zero();  ///< m, >= 0, half of each edge
};

/// A cylinder with flat ends around the segment from `start` to `end`. Radius 0 is a segment. An axis shorter than
/// kShortestCylinder has no direction to rely on: then it counts as the ball around its middle that contains it, so a
/// disc needs some thickness. Metres.
struct Cylinder {
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  Eigen::Vector3d end = Eigen::Vector3d::Zero();
  double radius = 0.0;  ///< m, >= 0
};

/// m. Coordinates of 10 km are rounded to 2e-12 m, which turns an axis of this length by 2e-5 rad at most.
inline constexpr double kShortestCylinder = 1e-7;

using Shape = std::variant<Capsule, Box, Cylinder>;

/// A named rigid body: what evidence and reports call it, and where it is in its owner's frame (the link frame of an
/// arm for links and carried objects, the world for fixed objects, its own frame for objects on a track).
struct Body {
  std::string name;
  Shape shape;
};

}  // namespace dualarm
