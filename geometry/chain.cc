#include "geometry/chain.h"

namespace dualarm {

Eigen::Isometry3d link_pose(const Base& base, double joint_position) {
  const double direction = base.heading + base.sense() * joint_position;
  return Eigen::Translation3d(base.position) * Eigen::AngleAxisd(direction, Eigen::Vector3d::UnitZ());
}

Capsule placed(const Capsule& capsule, const Eigen::Isometry3d& pose) {
  return {pose * capsule.start, pose * capsule.end, capsule.radius};
}

}  // namespace dualarm
