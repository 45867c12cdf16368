#pragma once

#include <Eigen/Core>
#include <string>

namespace dualarm {

/// All points within `radius` of the segment from `start` to `end`. Start equal to end is a sphere; radius 0 is a
/// segment. Metres, in whatever frame the owner says.
struct Capsule {
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  Eigen::Vector3d end = Eigen::Vector3d::Zero();
  double radius = 0.0;  ///< m, >= 0
};

/// A named rigid body: what evidence and reports call it, and where it is in its owner's frame (the link frame of an
/// arm for links and carried objects, the world for fixed objects).
struct Body {
  std::string name;
  Capsule capsule;
};

}  // namespace dualarm
