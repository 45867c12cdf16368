#include "geometry/chain.h"

namespace dualarm {

Eigen::Isometry3d link_pose(const Base& base, double joint_position) {
  const double direction = base.heading + base.sense() * joint_position;
  return Eigen::Translation3d(base.position) * Eigen::AngleAxisd(direction, Eigen::Vector3d::UnitZ());
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
