#pragma once

#include <Eigen/Core>

#include "geometry/body.h"

namespace dualarm {

/// Signed gap between two bodies in one frame, judged by FCL: negative when they overlap (segment distance minus both
/// radii), with the pair of nearest points (m).
struct Clearance {
  double distance = 0.0;
  Eigen::Vector3d point_on_first = Eigen::Vector3d::Zero();
  Eigen::Vector3d point_on_second = Eigen::Vector3d::Zero();
};

/// FCL's distance of two capsules given in the same frame.
Clearance clearance(const Capsule& first, const Capsule& second);

/// Upper bound (m) on how much `clearance` may overstate the distance of these two: FCL's closed form for capsules
/// loses digits on nearly parallel pairs. A proof subtracts it.
double clearance_error(const Capsule& first, const Capsule& second);

}  // namespace dualarm
