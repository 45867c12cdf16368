#include "core/verification/separation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <variant>

#include "core/verification/tolerances.h"
#include "geometry/support.h"

namespace dualarm {
namespace {

/// Largest second derivative of a unit of length that turns with the body, 1/s2.
double most_curvature(const TurningBody& body) { return body.most_rate * body.most_rate + body.most_rate_change; }

/// Bound on |d2/dt2 n.(y - origin of the carrier)| for all points y of `other`, where n turns with the carrier. In the
/// frame of n that is the acceleration of y: Euler's and the centrifugal part, Coriolis', and that of y itself. The
/// first three are at right angles to the carrier's axis, and the last to that of `other`: what turns in the plane of a
/// face comes no nearer.
double most_second_derivative(const TurningBody& carrier, const TurningBody& other, const Eigen::Vector3d& normal,
                              double half_interval) {
  const Eigen::Vector3d apart = other.origin - carrier.origin;
  const double relative_speed = (other.velocity - carrier.velocity).norm();
  const double farthest = carrier.axis.cross(apart).norm() + relative_speed * half_interval + other.extent;
  const double across_carrier = carrier.axis.cross(normal).norm();
  const double turned = carrier.axis == other.axis ? 0.0 : carrier.most_rate * half_interval;
  const double across_other = std::min(1.0, other.axis.cross(normal).norm() + turned);
  return across_carrier * (most_curvature(carrier) * farthest +
                           2.0 * carrier.most_rate * (relative_speed + other.most_rate * other.reach)) +
         across_other * most_curvature(other) * other.reach;
}

/// Lower bounds for the first and for the second half of an interval.
struct Halves {
  double before = 0.0;
  double after = 0.0;
};

/// The bounds with n turning with `carrier`; the normal points from the other body to it. In the frame of n the carrier
/// stands still. Of the other body the largest n.(y - origin of the carrier) counts: to first order that is linear in y
/// at any time, so that the farthest point in one direction attains it; and as the largest of functions linear in time
/// it is convex, so that on each half one of the ends is the worst.
Halves bounds(const TurningBody& carrier, const TurningBody& other, const Eigen::Vector3d& normal,
              double half_interval) {
  const Eigen::Vector3d turn_of_normal = carrier.rate * carrier.axis.cross(normal);
  const Eigen::Vector3d turn_of_other = other.rate * other.axis;
  const auto farthest_at = [&](double time) {
    const Eigen::Vector3d direction = normal + time * (turn_of_normal - turn_of_other.cross(normal));
    const Eigen::Vector3d y = farthest_point(other.shape, direction);
    const Eigen::Vector3d velocity = other.velocity - carrier.velocity + turn_of_other.cross(y - other.origin);
    return (normal + time * turn_of_normal).dot(y - carrier.origin) + time * normal.dot(velocity);
  };
  const double nearest =
      normal.dot(farthest_point(carrier.shape, -normal) - carrier.origin) -
      0.5 * half_interval * half_interval * most_second_derivative(carrier, other, normal, half_interval);
  const double in_the_middle = farthest_at(0.0);
  if (half_interval == 0.0) return {nearest - in_the_middle, nearest - in_the_middle};
  return {nearest - std::max(in_the_middle, farthest_at(-half_interval)),
          nearest - std::max(in_the_middle, farthest_at(half_interval))};
}

/// Upper bound on n.y over all points y of a capsule and all of the interval, for n that stands still: each end of its
/// axis goes no farther than its own distance from the axis of turning lets it. Infinite for other shapes.
double most_along(const TurningBody& body, const Eigen::Vector3d& normal, double half_interval) {
  const auto* capsule = std::get_if<Capsule>(&body.shape);
  if (capsule == nullptr) return std::numeric_limits<double>::infinity();
  const auto most_of_end = [&](const Eigen::Vector3d& end) {
    const double speed = body.most_rate * body.axis.cross(end - body.origin).norm() + body.velocity.norm();
    return normal.dot(end) + half_interval * speed;
  };
  return std::max(most_of_end(capsule->start), most_of_end(capsule->end)) + capsule->radius;
}

}  // namespace

double separation_bound(const TurningBody& first, const TurningBody& second, const Eigen::Vector3d& normal,
                        double half_interval) {
  const Halves with_first = bounds(first, second, normal, half_interval);
  const Halves with_second = bounds(second, first, -normal, half_interval);
  const double turning =
      std::min(std::max(with_first.before, with_second.before), std::max(with_first.after, with_second.after));
  const double standing = -most_along(first, -normal, half_interval) - most_along(second, normal, half_interval);
  return std::max(turning, standing) - kSeparationRounding;
}

}  // namespace dualarm
