#include "core/model/arm.h"

#include <cmath>

namespace dualarm {

GravityTorque paper_gravity(double mass, double length, double gravity) { return {0.5 * mass * gravity * length, 0.0}; }

GravityTorque field_gravity(double mass, double centre_of_mass, Eigen::Vector2d field, const Base& base) {
  // The link hangs where it points along the field; away from there it takes m |g| c sin(theta - theta_hanging) to
  // hold.
  const double hanging = base.sense() * (std::atan2(field.y(), field.x()) - base.heading);
  return {mass * field.norm() * centre_of_mass, std::remainder(hanging, 2.0 * std::numbers::pi)};
}

}  // namespace dualarm
