#include "core/model/problem.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace dualarm {
namespace {

/// Moment of inertia (kg m2) of a capsule of even density about the z axis of its link frame. The axis of the capsule
/// is parallel to the plane of motion, so the moment about its centre is the one across its axis.
double payload_inertia(const Capsule& in_link, double mass) {
  const double length = (in_link.end - in_link.start).norm();
  const double r = in_link.radius;
  const double sphere_share = r > 0.0 ? 4.0 * r / (4.0 * r + 3.0 * length) : 0.0;
  const double rod = (1.0 - sphere_share) * mass * (length * length / 12.0 + r * r / 4.0);
  const double caps = sphere_share * mass * (0.4 * r * r + 0.375 * r * length + 0.25 * length * length);
  const Eigen::Vector3d centre = 0.5 * (in_link.start + in_link.end);
  return rod + caps + mass * centre.head<2>().squaredNorm();
}

}  // namespace

bool PlanOptions::allows(Method method) const {
  return methods.empty() || std::find(methods.begin(), methods.end(), method) != methods.end();
}

std::vector<Body> moving_bodies(const Problem& problem, int arm) {
  const Arm& owner = problem.arms[arm];
  std::vector<Body> bodies = {{owner.name, {Eigen::Vector3d::Zero(), {owner.length, 0.0, 0.0}, owner.radius}}};
  for (const Object& object : problem.objects) {
    const auto* attached = std::get_if<AttachedPlacement>(&object.placement);
    if (attached != nullptr && attached->arm == arm) {
      bodies.push_back({object.name, placed(object.shape, attached->pose_in_link)});
    }
  }
  return bodies;
}

std::vector<Body> fixed_bodies(const Problem& problem) {
  std::vector<Body> bodies;
  for (const Object& object : problem.objects) {
    if (const auto* fixed = std::get_if<FixedPlacement>(&object.placement)) {
      bodies.push_back({object.name, placed(object.shape, fixed->pose)});
    }
  }
  return bodies;
}

Arm loaded_arm(const Problem& problem, int arm) {
  Arm loaded = problem.arms[arm];
  bool carries = false;
  // A sin(theta - phi) as the phasor A exp(-i phi): torques of the same joint add like phasors.
  std::complex<double> gravity = loaded.gravity.amplitude * std::polar(1.0, -loaded.gravity.phase);
  for (const Object& object : problem.objects) {
    const auto* attached = std::get_if<AttachedPlacement>(&object.placement);
    if (attached == nullptr || attached->arm != arm) continue;
    carries = true;
    const Capsule in_link = placed(object.shape, attached->pose_in_link);
    const Eigen::Vector3d centre = 0.5 * (in_link.start + in_link.end);
    const double bearing = loaded.base.sense() * std::atan2(centre.y(), centre.x());
    loaded.inertia += payload_inertia(in_link, attached->mass);
    gravity += attached->mass * loaded.payload_gravity * centre.head<2>().norm() *
               std::polar(1.0, bearing - loaded.payload_gravity_phase);
  }
  if (carries) loaded.gravity = {std::abs(gravity), -std::arg(gravity)};
  return loaded;
}

}  // namespace dualarm
