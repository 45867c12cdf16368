#include "core/verification/separation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/verification/tolerances.h"

namespace dualarm {
namespace {

/// Change of a vector that turns with a rate (rad/s) about the vertical, per second.
Eigen::Vector3d turning(const Eigen::Vector3d& vector, double rate) {
  return {-rate * vector.y(), rate * vector.x(), 0.0};
}

Eigen::Vector3d velocity(const Eigen::Vector3d& point, const TurningBody& body) {
  return turning(point - body.axis, body.rate);
}

/// Largest second derivative of a unit of length that turns with the body, 1/s2.
double most_curvature(const TurningBody& body) { return body.most_rate * body.most_rate + body.most_rate_change; }

/// Bound on |d2/dt2 n.(x - y)| where n turns with `carrier`. In the frame of n only the points of `other` move.
double most_second_derivative(const TurningBody& carrier, const TurningBody& other) {
  const double farthest = (other.axis - carrier.axis).head<2>().norm() + other.reach;
  return most_curvature(carrier) * farthest + 2.0 * carrier.most_rate * other.most_rate * other.reach +
         most_curvature(other) * other.reach;
}

/// The bound with n turning at a rate, without the second-order term and the radii.
double first_order(const TurningBody& first, const TurningBody& second, const Eigen::Vector3d& normal, double rate,
                   double half_interval) {
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& x : {first.capsule.start, first.capsule.end}) {
    for (const Eigen::Vector3d& y : {second.capsule.start, second.capsule.end}) {
      const Eigen::Vector3d apart = x - y;
      const double change = turning(normal, rate).dot(apart) + normal.dot(velocity(x, first) - velocity(y, second));
      least = std::min(least, normal.dot(apart) - std::abs(change) * half_interval);
    }
  }
  return least;
}

}  // namespace

double separation_bound(const TurningBody& first, const TurningBody& second, const Eigen::Vector3d& normal,
                        double half_interval) {
  const double half_square = 0.5 * half_interval * half_interval;
  const double with_first = first_order(first, second, normal, first.rate, half_interval) -
                            most_second_derivative(first, second) * half_square;
  const double with_second = first_order(first, second, normal, second.rate, half_interval) -
                             most_second_derivative(second, first) * half_square;
  return std::max(with_first, with_second) - first.capsule.radius - second.capsule.radius - kSeparationRounding;
}

}  // namespace dualarm
