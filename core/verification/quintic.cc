#include "core/verification/quintic.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dualarm {
namespace {

/// Infinite where a value is not a number, so that nothing is proven with it.
template <std::size_t kSize>
double largest_magnitude(const std::array<double, kSize>& values) {
  double most = 0.0;
  for (double value : values) {
    if (!(std::abs(value) <= most))
      most = std::isnan(value) ? std::numeric_limits<double>::infinity() : std::abs(value);
  }
  return most;
}

/// Bernstein coefficients of the derivative from those of a polynomial over `duration`.
template <std::size_t kSize>
std::array<double, kSize - 1> differentiated(const std::array<double, kSize>& bernstein, double duration) {
  std::array<double, kSize - 1> derivative;
  for (std::size_t i = 0; i + 1 < kSize; ++i) {
    derivative[i] = static_cast<double>(kSize - 1) * (bernstein[i + 1] - bernstein[i]) / duration;
  }
  return derivative;
}

/// What the derivative of an order makes of a power: power (power - 1) ... (power - order + 1).
constexpr std::array<std::array<double, 6>, 6> kFalling = {{{1.0, 1.0, 1.0, 1.0, 1.0, 1.0},
                                                            {0.0, 1.0, 2.0, 3.0, 4.0, 5.0},
                                                            {0.0, 0.0, 2.0, 6.0, 12.0, 20.0},
                                                            {0.0, 0.0, 0.0, 6.0, 24.0, 60.0},
                                                            {0.0, 0.0, 0.0, 0.0, 24.0, 120.0},
                                                            {0.0, 0.0, 0.0, 0.0, 0.0, 120.0}}};

/// Coefficients of powers of (time - start) / duration, rad.
std::array<double, 6> coefficients_between(const Knot& start, const Knot& end) {
  const double h = end.time - start.time;
  const double first = h * start.velocity;
  const double second = 0.5 * h * h * start.acceleration;
  // What the parabola of the start leaves of position, velocity and acceleration at the end, in units of position.
  const double p = end.position - start.position - first - second;
  const double v = h * (end.velocity - start.velocity) - 2.0 * second;
  const double a = 0.5 * h * h * (end.acceleration - start.acceleration);
  return {start.position, first, second, 10.0 * p - 4.0 * v + a, -15.0 * p + 7.0 * v - 2.0 * a, 6.0 * p - 3.0 * v + a};
}

}  // namespace

JointState Quintic::state(const Knot& start, const Knot& end, double time) {
  const std::array<double, 6> c = coefficients_between(start, end);
  const double duration = end.time - start.time;
  const double u = std::clamp((time - start.time) / duration, 0.0, 1.0);
  return {c[0] + u * (c[1] + u * (c[2] + u * (c[3] + u * (c[4] + u * c[5])))),
          (c[1] + u * (2.0 * c[2] + u * (3.0 * c[3] + u * (4.0 * c[4] + u * (5.0 * c[5]))))) / duration};
}

Quintic::Quintic(const Knot& start, const Knot& end)
    : start_(start.time), duration_(end.time - start.time), coefficients_(coefficients_between(start, end)) {
  const double h = duration_;
  const double change = end.position - start.position;
  const double v0 = start.velocity;
  const double v1 = end.velocity;
  const double a0 = start.acceleration;
  const double a1 = end.acceleration;

  // A polynomial lies between the least and the largest of its Bernstein coefficients. Velocity and acceleration are
  // written out, because differences of the position's coefficients lose digits over short times.
  const std::array<double, 5> velocity = {
      v0, v0 + 0.25 * h * a0, 5.0 * change / h - 2.0 * (v0 + v1) + 0.25 * h * (a1 - a0), v1 - 0.25 * h * a1, v1};
  const std::array<double, 4> acceleration = {a0, 20.0 * (change / h - 0.6 * v0 - 0.4 * v1) / h + a1 - 2.0 * a0,
                                              20.0 * (0.4 * v0 + 0.6 * v1 - change / h) / h + a0 - 2.0 * a1, a1};
  const std::array<double, 3> jerk = differentiated(acceleration, h);
  const std::array<double, 2> snap = differentiated(jerk, h);
  const std::array<double, 1> crackle = differentiated(snap, h);
  most_ = {0.0,
           largest_magnitude(velocity),
           largest_magnitude(acceleration),
           largest_magnitude(jerk),
           largest_magnitude(snap),
           largest_magnitude(crackle)};

  // Half a last digit of both positions, both velocities and both times. The second derivative of the quintic answers
  // a change of one position by at most 5.8 / h^2 and of one velocity by at most 4 / h; the first by 1.9 / h and 1.
  const double half_digit = 0.5 * std::numeric_limits<double>::epsilon();
  const double times = std::abs(start.time) + std::abs(end.time);
  const double of_position =
      half_digit * (std::abs(start.position) + std::abs(end.position) + std::max(std::abs(v0), std::abs(v1)) * times);
  const double of_velocity = half_digit * (std::abs(v0) + std::abs(v1) + (std::abs(a0) + std::abs(a1)) * times);
  velocity_rounding_ = 2.0 * of_position / h + of_velocity;
  acceleration_rounding_ = 6.0 * of_position / (h * h) + 4.0 * of_velocity / h;
}

double Quintic::derivative(int order, double time) const {
  const double u = std::clamp((time - start_) / duration_, 0.0, 1.0);
  double value = 0.0;
  for (int power = 5; power >= order; --power) value = value * u + kFalling[order][power] * coefficients_[power];
  for (int i = 0; i < order; ++i) value /= duration_;
  return value;
}

std::array<double, 6> Quintic::in_the_middle() const {
  // Horner's scheme again and again: the coefficients of powers of the way from the middle.
  std::array<double, 6> shifted = coefficients_;
  for (int first = 0; first < 5; ++first) {
    for (int power = 4; power >= first; --power) shifted[power] += 0.5 * shifted[power + 1];
  }
  double factor = 1.0;
  for (int order = 1; order <= 5; ++order) {
    factor *= order / duration_;
    shifted[order] *= factor;
  }
  return shifted;
}

}  // namespace dualarm
