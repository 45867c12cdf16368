#include "geometry/clearance.h"

#include <fcl/geometry/shape/capsule.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>

namespace dualarm {
namespace {

// m. FCL decides "parallel" by an absolute threshold (2e-14 m2 on the product of both lengths and the sine between
// them), so that an axis of length a may cost 2e-14 / a of accuracy. A shorter axis than this is judged as its
// midpoint.
constexpr double kShortestAxis = 1e-7;

// m. Half the shortest axis, or what the threshold costs at the shortest axis, whichever is more, with room to spare.
constexpr double kFloorOfError = 3e-7;

// m per m of the longer axis. FCL solves 2 x 2 equations whose determinant drowns in rounding when the angle between
// the axes falls below the square root of the machine's precision (1.5e-8); the test measures 2e-8 at worst.
constexpr double kErrorPerLength = 4e-8;

double axis_length(const Capsule& capsule) { return (capsule.end - capsule.start).norm(); }

/// FCL's capsule lies centred along its own z axis, and its length does not count the caps.
struct FclBody {
  fcl::Capsuled shape;
  fcl::Transform3d pose;
};

FclBody to_fcl(const Capsule& capsule) {
  const double length = axis_length(capsule);
  const bool is_sphere = length < kShortestAxis;
  FclBody body = {fcl::Capsuled(capsule.radius, is_sphere ? 0.0 : length), fcl::Transform3d::Identity()};
  body.pose.translation() = 0.5 * (capsule.start + capsule.end);
  if (!is_sphere) {
    const Eigen::Vector3d z = (capsule.end - capsule.start) / length;
    const Eigen::Vector3d x = z.unitOrthogonal();
    body.pose.linear() << x, z.cross(x), z;
  }
  return body;
}

}  // namespace

Clearance clearance(const Capsule& first, const Capsule& second) {
  const FclBody a = to_fcl(first);
  const FclBody b = to_fcl(second);
  // Never signed: FCL 0.7 then leaves the closed form and aborts the process on some touching pairs. The unsigned call
  // is negative on overlap for two capsules all the same.
  const fcl::DistanceRequestd request(/*enable_nearest_points=*/true);
  fcl::DistanceResultd result;
  fcl::distance(&a.shape, a.pose, &b.shape, b.pose, request, result);
  return {result.min_distance, result.nearest_points[0], result.nearest_points[1]};
}

double clearance_error(const Capsule& first, const Capsule& second) {
  return kFloorOfError + kErrorPerLength * std::max(axis_length(first), axis_length(second));
}

}  // namespace dualarm
