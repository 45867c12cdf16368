#pragma once

#include <Eigen/Core>
#include <array>

#include "geometry/body.h"

namespace dualarm {

/// A body that turns about an axis of constant direction through an origin of constant velocity: at the middle of an
/// interval of time, with bounds that hold throughout. A link turns about its joint, an object on a track about its
/// frame's origin; what stands still has no rate and any origin.
struct TurningBody {
  Shape shape;                                         ///< m, world, in the middle
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();    ///< m, world, in the middle, a point of the axis
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s, of the origin, all of the time
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();     ///< unit
  double rate = 0.0;                                   ///< rad/s, about the axis, in the middle
  double most_rate = 0.0;                              ///< rad/s, largest magnitude
  double most_rate_change = 0.0;                       ///< rad/s2, largest magnitude
  double most_turn = 0.0;                              ///< rad, from the middle to any other time
  double reach = 0.0;                                  ///< m, of any of the body's points from the axis
  double extent = 0.0;                                 ///< m, of any of the body's points from the origin, >= reach
  double farthest_way = 0.0;                           ///< m, of any of the body's points from the middle
};

/// A lower bound on a distance from the middle of an interval of time on, in one direction: after t s the least of
/// value - rate t - curvature t^2 / 2 over its points. That has no local minimum: over a stretch of time one of its
/// ends is the least.
struct Fall {
  struct Point {
    double value = 0.0;  ///< m
    double rate = 0.0;   ///< m/s
  };
  std::array<Point, 2> points;
  double curvature = 0.0;  ///< m/s2, not negative

  /// Over all of the time (s) from the middle on.
  double least_until(double time) const;

  /// Until when (s, at most `latest` >= 0) it is nowhere below a distance (m).
  double keeps(double distance, double latest) const;
};

/// What separation proves of two bodies: in each direction of time a Fall with either of them as the carrier of the
/// normal, each a bound of its own, and for capsules one with a normal that stands still.
struct Separation {
  double half_interval = 0.0;  ///< s
  std::array<Fall, 2> before;
  std::array<Fall, 2> after;
  double standing = 0.0;  ///< m, over all of the interval; minus infinity for other shapes

  double least_before() const;  ///< m, over the first half
  double least_after() const;   ///< m, over the second half
};

/// Lower bounds (m) on the distance of two convex bodies over an interval of time, by separation: for any unit vector
/// n(t), the distance is at least min n.x - max n.y over points x of the first and y of the second. `normal` is n in
/// the middle (any unit vector; the bound is tight for the one from the nearest point of the second to that of the
/// first), and in each half of the interval n turns with the first or with the second body, whichever proves more:
/// where two faces roll over each other, a corner of the one is nearest before and one of the other after. n.(x - y)
/// has a known derivative in the middle and a bounded second one, so that the error of the bound falls with the square
/// of the interval where a speed bound's falls with the interval. For two capsules n may also stand still: then each
/// end of an axis counts with its own speed, so that links whose joints are their nearest points are proven apart at
/// once. Theory, section 5.
Separation separation(const TurningBody& first, const TurningBody& second, const Eigen::Vector3d& normal,
                      double half_interval);

}  // namespace dualarm
