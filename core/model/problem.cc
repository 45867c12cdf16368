#include "core/model/problem.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/model/payload_inertia.h"
#include "geometry/chain.h"
#include "geometry/support.h"

namespace dualarm {
bool PlanOptions::allows(Method method) const {
  return methods.empty() || std::find(methods.begin(), methods.end(), method) != methods.end();
}

std::vector<Body> moving_bodies(const Problem& problem, int arm) {
  const Arm& owner = problem.arms[arm];
  std::vector<Body> bodies = {{owner.name, Capsule{Eigen::Vector3d::Zero(), {owner.length, 0.0, 0.0}, owner.radius}}};
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

std::vector<TrackedBody> tracked_bodies(const Problem& problem) {
  std::vector<TrackedBody> bodies;
  for (const Object& object : problem.objects) {
    if (const auto* moving = std::get_if<MovingPlacement>(&object.placement)) {
      bodies.push_back({{object.name, object.shape}, &moving->track});
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
    const Shape in_link = placed(object.shape, attached->pose_in_link);
    const Eigen::Vector3d middle = centre(in_link);
    const double bearing = loaded.base.sense() * std::atan2(middle.y(), middle.x());
    loaded.inertia += payload_inertia(in_link, attached->mass);
    gravity += attached->mass * loaded.payload_gravity * middle.head<2>().norm() *
               std::polar(1.0, bearing - loaded.payload_gravity_phase);
  }
  if (carries) loaded.gravity = {std::abs(gravity), -std::arg(gravity)};
  return loaded;
}

}  // namespace dualarm
