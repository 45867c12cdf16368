#include "geometry/chain.h"

#include <cmath>

namespace dualarm {

Eigen::Isometry3d link_pose(const Base& base, double joint_position) {
  const double direction = base.heading + base.sense() * joint_position;
  const double cosine = std::cos(direction);
  const double sine = std::sin(direction);
  Eigen::Isometry3d pose;
  pose.matrix() << cosine, -sine, 0.0, base.position.x(),  //
      sine, cosine, 0.0, base.position.y(),                //
      0.0, 0.0, 1.0, base.position.z(),                    //
      0.0, 0.0, 0.0, 1.0;
  return pose;
}

Capsule placed(const Capsule& capsule, const Eigen::Isometry3d& pose) {
  return {pose * capsule.start, pose * capsule.end, capsule.radius};
}

Shape placed(const Shape& shape, const Eigen::Isometry3d& pose) {
  struct Placed {
    const Eigen::Isometry3d& pose;
    Shape operator()(const Capsule& capsule) const { return placed(capsule, pose); }
    Shape operator()(const Box& box) const { return Box{pose * box.pose, box.half_extents}; }
    Shape operator()(const Cylinder& cylinder) const {
      return Cylinder{pose * cylinder.start, pose * cylinder.end, cylinder.radius};
    }
  };
  return std::visit(Placed{pose}, shape);
}

}  // namespace dualarm
