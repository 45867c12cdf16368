#include "server/request/dynamics.h"

#include <fmt/format.h>

namespace dualarm {
namespace {

constexpr double kStandardGravity = 9.81;  // m/s2 [paper]

struct Gravity {
  GravityTorque torque;
  double payload = 0.0;        // m/s2
  double payload_phase = 0.0;  // rad
};

Gravity read_paper_gravity(const wire::PaperGravity& message, const Field& field, double mass, const Arm& arm) {
  const double gravity = message.has_gravity_m_per_s2()
                             ? field.number("gravity_m_per_s2", message.gravity_m_per_s2(), ranges::kGravity)
                             : kStandardGravity;
  return {paper_gravity(mass, arm.length, gravity), gravity, 0.0};
}

Gravity read_gravity_torque(const wire::GravityTorque& message, const Field& field) {
  const double amplitude = field.number("amplitude_newton_meters", message.amplitude_newton_meters(), ranges::kTorque);
  const double phase = field.number("phase_rad", message.phase_rad(), ranges::kAngle);
  const double payload = field.number("payload_gravity_m_per_s2", message.payload_gravity_m_per_s2(), ranges::kGravity);
  return {{amplitude, phase}, payload, phase};
}

Gravity read_gravity_field(const wire::GravityField& message, const Field& field, double mass, const Arm& arm) {
  const double x = field.number("x_m_per_s2", message.x_m_per_s2(), ranges::kFieldComponent);
  const double y = field.number("y_m_per_s2", message.y_m_per_s2(), ranges::kFieldComponent);
  const double centre = field.number("center_of_mass_m", message.center_of_mass_m(), ranges::kCoordinate);
  const GravityTorque unit = field_gravity(1.0, 1.0, {x, y}, arm.base);
  return {field_gravity(mass, centre, {x, y}, arm.base), unit.amplitude, unit.phase};
}

Gravity read_gravity(const wire::Dynamics& message, const Field& field, double mass, const Arm& arm) {
  switch (message.gravity_case()) {
    case wire::Dynamics::kTorque:
      return read_gravity_torque(message.torque(), field.child("torque"));
    case wire::Dynamics::kField:
      return read_gravity_field(message.field(), field.child("field"), mass, arm);
    case wire::Dynamics::kPaper:
    case wire::Dynamics::GRAVITY_NOT_SET:
      break;
  }
  return read_paper_gravity(message.paper(), field.child("paper"), mass, arm);
}

}  // namespace

Dynamics read_dynamics(const wire::Dynamics& message, const Field& field, const Arm& arm) {
  const double mass = field.number("mass_kg", message.mass_kg(), ranges::kMass);
  const double moment =
      field.number("moment_of_inertia_kg_m2", message.moment_of_inertia_kg_m2(), ranges::kMomentOfInertia);
  const double friction = field.number("viscous_friction_newton_meter_seconds",
                                       message.viscous_friction_newton_meter_seconds(), ranges::kFriction);
  const double inertia = moment + mass * arm.length * arm.length;
  if (inertia >= 0.0 && inertia < ranges::kTotalInertia.min) {
    field.complain("moment_of_inertia_kg_m2",
                   fmt::format("and mass_kg give an inertia of {} kg m^2 in all, must be at least {}", inertia,
                               ranges::kTotalInertia.min));
  }
  const Gravity gravity = read_gravity(message, field, mass, arm);
  return {inertia, gravity.torque, gravity.payload, gravity.payload_phase, friction};
}

}  // namespace dualarm
