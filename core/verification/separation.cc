#include "core/verification/separation.h"

#include <Eigen/Geometry>
#include <algorithm>
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

/// The same for two capsules: of their axes, less both radii. What an end of the other axis does along n is known to
/// first order; between the ends nothing is farther than either.
Halves bounds(const TurningBody& carrier, const Capsule& its, const TurningBody& other, const Capsule& others,
              const Eigen::Vector3d& normal, double half_interval) {
  const Eigen::Vector3d turn_of_normal = carrier.rate * carrier.axis.cross(normal);
  const Eigen::Vector3d turn_of_other = other.rate * other.axis;
  const double drift = normal.dot(other.velocity - carrier.velocity);
  struct Along {
    double value;
    double rate;
  };
  const auto along = [&](const Eigen::Vector3d& y) {
    const Eigen::Vector3d from_carrier = y - carrier.origin;
    return Along{normal.dot(from_carrier),
                 turn_of_normal.dot(from_carrier) + normal.dot(turn_of_other.cross(y - other.origin)) + drift};
  };
  const Along start = along(others.start);
  const Along end = along(others.end);
  const auto farthest_at = [&](double time) {
    return std::max(start.value + time * start.rate, end.value + time * end.rate);
  };
  const double nearest =
      std::min(normal.dot(its.start - carrier.origin), normal.dot(its.end - carrier.origin)) - its.radius -
      others.radius -
      0.5 * half_interval * half_interval * most_second_derivative(carrier, other, normal, half_interval);
  const double in_the_middle = std::max(start.value, end.value);
  return {nearest - std::max(in_the_middle, farthest_at(-half_interval)),
          nearest - std::max(in_the_middle, farthest_at(half_interval))};
}

/// Upper bound on n.y over all points y of a capsule and all of the interval, for n that stands still: each end of its
/// axis goes no farther than its own distance from the axis of turning lets it.
double most_along(const TurningBody& body, const Capsule& its, const Eigen::Vector3d& normal, double half_interval) {
  const double drift = half_interval * body.velocity.norm();
  const auto most_of_end = [&](const Eigen::Vector3d& end) {
    return normal.dot(end) + body.most_turn * body.axis.cross(end - body.origin).norm();
  };
  return std::max(most_of_end(its.start), most_of_end(its.end)) + its.radius + drift;
}

/// The better one for each half.
double better(const Halves& left, const Halves& right) {
  return std::min(std::max(left.before, right.before), std::max(left.after, right.after));
}

double bound_of_capsules(const TurningBody& first, const Capsule& its, const TurningBody& second, const Capsule& others,
                         const Eigen::Vector3d& normal, double half_interval) {
  const double turning = better(bounds(first, its, second, others, normal, half_interval),
                                bounds(second, others, first, its, -normal, half_interval));
  const double standing =
      -most_along(first, its, -normal, half_interval) - most_along(second, others, normal, half_interval);
  return std::max(turning, standing);
}

}  // namespace

double separation_bound(const TurningBody& first, const TurningBody& second, const Eigen::Vector3d& normal,
                        double half_interval) {
  const auto* first_capsule = std::get_if<Capsule>(&first.shape);
  const auto* second_capsule = std::get_if<Capsule>(&second.shape);
  if (first_capsule != nullptr && second_capsule != nullptr) {
    return bound_of_capsules(first, *first_capsule, second, *second_capsule, normal, half_interval) -
           kSeparationRounding;
  }
  return better(bounds(first, second, normal, half_interval), bounds(second, first, -normal, half_interval)) -
         kSeparationRounding;
}

}  // namespace dualarm
