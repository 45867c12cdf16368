#include "core/verification/separation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "core/verification/tolerances.h"
#include "geometry/support.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

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

/// With n turning with one body, backwards and forwards in time.
struct Falls {
  Fall before;
  Fall after;
};

/// How far a point of the other body is along n, and how fast it goes farther.
struct Along {
  double value = 0.0;  // m
  double rate = 0.0;   // m/s
};

Falls falls(double nearest, const std::array<Along, 2>& backwards, const std::array<Along, 2>& forwards,
            double curvature) {
  Falls result;
  for (std::size_t i = 0; i < 2; ++i) {
    result.before.points[i] = {nearest - backwards[i].value, -backwards[i].rate};
    result.after.points[i] = {nearest - forwards[i].value, forwards[i].rate};
  }
  result.before.curvature = result.after.curvature = curvature;
  return result;
}

/// The bounds with n turning with `carrier`; the normal points from the other body to it. In the frame of n the carrier
/// stands still. Of the other body the largest n.(y - origin of the carrier) counts: to first order that is linear in y
/// at any time, so that the farthest point in one direction attains it; and as the largest of functions linear in time
/// it is convex, so that in each half it is no larger than its chord.
Falls falls_on(const TurningBody& carrier, const TurningBody& other, const Eigen::Vector3d& normal,
               double half_interval) {
  const Eigen::Vector3d turn_of_normal = carrier.rate * carrier.axis.cross(normal);
  const Eigen::Vector3d turn_of_other = other.rate * other.axis;
  const auto farthest_at = [&](double time) {
    const Eigen::Vector3d direction = normal + time * (turn_of_normal - turn_of_other.cross(normal));
    const Eigen::Vector3d y = farthest_point(other.shape, direction);
    const Eigen::Vector3d velocity = other.velocity - carrier.velocity + turn_of_other.cross(y - other.origin);
    return (normal + time * turn_of_normal).dot(y - carrier.origin) + time * normal.dot(velocity);
  };
  const double nearest = normal.dot(farthest_point(carrier.shape, -normal) - carrier.origin) - kSeparationRounding;
  const double in_the_middle = farthest_at(0.0);
  const auto chord_to = [&](double time) {
    return Along{in_the_middle, time == 0.0 ? 0.0 : (farthest_at(time) - in_the_middle) / time};
  };
  const Along backwards = chord_to(-half_interval);
  const Along forwards = chord_to(half_interval);
  return falls(nearest, {backwards, backwards}, {forwards, forwards},
               most_second_derivative(carrier, other, normal, half_interval));
}

/// The same for two capsules: of their axes, less both radii. What an end of the other axis does along n is known to
/// first order; between the ends nothing is farther than either.
Falls falls_on(const TurningBody& carrier, const Capsule& its, const TurningBody& other, const Capsule& others,
               const Eigen::Vector3d& normal, double half_interval) {
  const Eigen::Vector3d turn_of_normal = carrier.rate * carrier.axis.cross(normal);
  const Eigen::Vector3d turn_of_other = other.rate * other.axis;
  const double drift = normal.dot(other.velocity - carrier.velocity);
  const auto along = [&](const Eigen::Vector3d& y) {
    const Eigen::Vector3d from_carrier = y - carrier.origin;
    return Along{normal.dot(from_carrier),
                 turn_of_normal.dot(from_carrier) + normal.dot(turn_of_other.cross(y - other.origin)) + drift};
  };
  const std::array<Along, 2> ends = {along(others.start), along(others.end)};
  const double nearest = std::min(normal.dot(its.start - carrier.origin), normal.dot(its.end - carrier.origin)) -
                         its.radius - others.radius - kSeparationRounding;
  return falls(nearest, ends, ends, most_second_derivative(carrier, other, normal, half_interval));
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

/// With a normal that stands still.
double standing_bound(const TurningBody& first, const Capsule& its, const TurningBody& second, const Capsule& others,
                      const Eigen::Vector3d& normal, double half_interval) {
  return -most_along(first, its, -normal, half_interval) - most_along(second, others, normal, half_interval) -
         kSeparationRounding;
}

}  // namespace

double Fall::least_until(double time) const {
  double least = kInfinity;
  for (const Point& point : points) {
    const double in_the_end = point.value - time * (point.rate + 0.5 * curvature * time);
    if (std::isnan(in_the_end)) return -kInfinity;
    least = std::min({least, point.value, in_the_end});
  }
  return least;
}

double Fall::keeps(double distance, double latest) const {
  for (const Point& point : points) {
    const double room = point.value - distance;
    if (!(room >= 0.0)) return 0.0;
    const double slowness = point.rate + std::sqrt(point.rate * point.rate + 2.0 * curvature * room);
    if (slowness <= 0.0) continue;  // it never falls
    const double until = 2.0 * room / slowness;
    if (!(until >= latest)) latest = until > 0.0 ? until : 0.0;
  }
  return latest;
}

double Separation::least_before() const {
  return std::max({before[0].least_until(half_interval), before[1].least_until(half_interval), standing});
}

double Separation::least_after() const {
  return std::max({after[0].least_until(half_interval), after[1].least_until(half_interval), standing});
}

Separation separation(const TurningBody& first, const TurningBody& second, const Eigen::Vector3d& normal,
                      double half_interval) {
  const auto* its = std::get_if<Capsule>(&first.shape);
  const auto* others = std::get_if<Capsule>(&second.shape);
  const bool are_capsules = its != nullptr && others != nullptr;
  const Falls on_first = are_capsules ? falls_on(first, *its, second, *others, normal, half_interval)
                                      : falls_on(first, second, normal, half_interval);
  const Falls on_second = are_capsules ? falls_on(second, *others, first, *its, -normal, half_interval)
                                       : falls_on(second, first, -normal, half_interval);
  const double standing =
      are_capsules ? standing_bound(first, *its, second, *others, normal, half_interval) : -kInfinity;
  return {half_interval, {on_first.before, on_second.before}, {on_first.after, on_second.after}, standing};
}

}  // namespace dualarm
