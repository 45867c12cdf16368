#include "core/verification/joint_torque.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dualarm {
namespace {

/// Bernstein coefficients of 1, w, w^2, w^3 and w^4 over [-1, 1].
constexpr std::array<std::array<double, 5>, 5> kBernstein = {{{1.0, 1.0, 1.0, 1.0, 1.0},
                                                              {-1.0, -0.5, 0.0, 0.5, 1.0},
                                                              {1.0, 0.0, -1.0 / 3.0, 0.0, 1.0},
                                                              {-1.0, 0.5, 0.0, -0.5, 1.0},
                                                              {1.0, -1.0, 1.0, -1.0, 1.0}}};

/// Derivatives of order 0 to 4 of the sine of an angle from those of the angle, q[0] the angle itself: Faa di Bruno.
std::array<double, 5> of_sine(const std::array<double, 6>& q) {
  const double s = std::sin(q[0]);
  const double c = std::cos(q[0]);
  return {
      s, c * q[1], c * q[2] - s * q[1] * q[1], c * (q[3] - q[1] * q[1] * q[1]) - 3.0 * s * q[1] * q[2],
      c * (q[4] - 6.0 * q[1] * q[1] * q[2]) + s * (q[1] * q[1] * q[1] * q[1] - 4.0 * q[1] * q[3] - 3.0 * q[2] * q[2])};
}

/// Bound on the magnitude of the fifth, over a piece.
double most_fifth_of_sine(const Quintic& piece) {
  const double v = piece.most(1);
  const double a = piece.most(2);
  return piece.most(5) + 5.0 * v * piece.most(4) + 10.0 * a * piece.most(3) +
         v * (10.0 * v * piece.most(3) + 15.0 * a * a + 10.0 * v * v * a + v * v * v * v);
}

/// The extremes of a polynomial's Bernstein coefficients after `halvings` of its interval, by de Casteljau: each takes
/// three quarters of what they exaggerate.
Interval extremes(std::array<double, 5> left, int halvings) {
  if (halvings == 0) {
    const auto [least, most] = std::minmax_element(left.begin(), left.end());
    return {*least, *most};
  }
  std::array<double, 5> right = left;
  for (int round = 1; round < 5; ++round) {
    for (int i = 4; i >= round; --i) left[i] = 0.5 * (left[i - 1] + left[i]);
    for (int i = 0; i < 5 - round; ++i) right[i] = 0.5 * (right[i] + right[i + 1]);
  }
  const Interval first = extremes(left, halvings - 1);
  const Interval second = extremes(right, halvings - 1);
  return {std::min(first.lower, second.lower), std::max(first.upper, second.upper)};
}

}  // namespace

Interval JointTorque::over(const Quintic& piece, Interval enough) const {
  std::array<double, 6> q = piece.in_the_middle();
  q[0] -= gravity_.phase;
  const std::array<double, 5> sine = of_sine(q);
  const double half = 0.5 * piece.duration();
  std::array<double, 5> bernstein = {};
  double factor = 1.0;  // half^order / order!
  for (int order = 0; order < 5; ++order) {
    const double of_inertia = order < 4 ? inertia_ * q[order + 2] : 0.0;
    const double term = factor * (of_inertia + friction_ * q[order + 1] + gravity_.amplitude * sine[order]);
    for (int i = 0; i < 5; ++i) bernstein[i] += term * kBernstein[order][i];
    factor *= half / (order + 1);
  }
  // What a quintic leaves of the velocity after degree four is nothing, of the acceleration after three.
  const double remainder = factor * std::abs(gravity_.amplitude) * most_fifth_of_sine(piece);
  const auto after = [&](int halvings) {
    const Interval polynomial = extremes(bernstein, halvings);
    return Interval{polynomial.lower - remainder, polynomial.upper + remainder};
  };
  const Interval quick = after(0);
  constexpr int kHalvings = 2;
  return enough.contains(quick.lower) && enough.contains(quick.upper) ? quick : after(kHalvings);
}

double JointTorque::second_derivative(const std::array<double, 6>& q) const {
  const double angle = q[0] - gravity_.phase;
  const double of_gravity = std::cos(angle) * q[2] - std::sin(angle) * q[1] * q[1];
  const double without_friction = inertia_ * q[4] + gravity_.amplitude * of_gravity;
  return friction_ == 0.0 ? without_friction : without_friction + friction_ * q[3];
}

double JointTorque::second_derivative(const Quintic& piece, double time) const {
  return second_derivative({piece.derivative(0, time), piece.derivative(1, time), piece.derivative(2, time),
                            piece.derivative(3, time), piece.derivative(4, time), 0.0});
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
