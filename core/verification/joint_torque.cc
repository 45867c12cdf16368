#include "core/verification/joint_torque.h"

#include <cmath>

namespace dualarm {

double JointTorque::second_derivative(const Quintic& piece, double time) const {
  const double angle = piece.derivative(0, time) - gravity_.phase;
  const double velocity = piece.derivative(1, time);
  const double of_gravity = std::cos(angle) * piece.derivative(2, time) - std::sin(angle) * velocity * velocity;
  const double without_friction = inertia_ * piece.derivative(4, time) + gravity_.amplitude * of_gravity;
  return friction_ == 0.0 ? without_friction : without_friction + friction_ * piece.derivative(3, time);
}

double JointTorque::most_third_derivative(const Quintic& piece) const {
  const double speed = piece.most(1);
  return inertia_ * piece.most(5) +
         std::abs(gravity_.amplitude) * (piece.most(3) + 3.0 * speed * piece.most(2) + speed * speed * speed) +
         friction_ * piece.most(4);
}

Quantity JointTorque::along(const Quintic& piece) const {
  const auto value = [this, &piece](double time) {
    const double velocity = friction_ == 0.0 ? 0.0 : piece.derivative(1, time);
    return at({piece.derivative(0, time), velocity}, piece.derivative(2, time));
  };
  const double third_derivative = most_third_derivative(piece);
  const auto curvature = [this, &piece, third_derivative](Interval time) {
    const double middle = 0.5 * (time.lower + time.upper);
    return std::abs(second_derivative(piece, middle)) + third_derivative * 0.5 * time.length();
  };
  return {value, curvature, rounding(piece)};
}

}  // namespace dualarm
