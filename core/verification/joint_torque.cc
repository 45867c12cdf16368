#include "core/verification/joint_torque.h"

#include <cmath>

namespace dualarm {

double JointTorque::at(double position, double acceleration) const {
  return inertia_ * acceleration + gravity_.amplitude * std::sin(position - gravity_.phase);
}

Quantity JointTorque::along(const Quintic& piece) const {
  const auto value = [this, &piece](double time) { return at(piece.derivative(0, time), piece.derivative(2, time)); };
  const double speed = piece.most(1);
  const double third_derivative =
      inertia_ * piece.most(5) +
      std::abs(gravity_.amplitude) * (piece.most(3) + 3.0 * speed * piece.most(2) + speed * speed * speed);
  const auto curvature = [this, &piece, third_derivative](Interval time) {
    const double middle = 0.5 * (time.lower + time.upper);
    const double angle = piece.derivative(0, middle) - gravity_.phase;
    const double velocity = piece.derivative(1, middle);
    const double of_gravity = std::cos(angle) * piece.derivative(2, middle) - std::sin(angle) * velocity * velocity;
    const double in_the_middle = inertia_ * piece.derivative(4, middle) + gravity_.amplitude * of_gravity;
    return std::abs(in_the_middle) + third_derivative * 0.5 * time.length();
  };
  return {value, curvature, inertia_ * piece.acceleration_rounding()};
}

}  // namespace dualarm
