#include "tests/geometry/random_shapes.h"

#include <cmath>
#include <numbers>

#include "geometry/chain.h"
#include "geometry/support.h"

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

Eigen::Vector3d RandomShapes::direction() {
  if (dice_.happens(0.2)) return Eigen::Vector3d::Unit(dice_.one_of(3));
  const Eigen::Vector3d any(dice_.between(-1.0, 1.0), dice_.between(-1.0, 1.0), dice_.between(-1.0, 1.0));
  return any.normalized();
}

Eigen::Isometry3d RandomShapes::pose(double size) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = size * dice_.between(0.0, 2.0) * direction();
  if (dice_.happens(0.3)) {
    pose.linear() = Eigen::AngleAxisd(0.5 * kPi * dice_.one_of(4), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  } else {
    pose.linear() = Eigen::AngleAxisd(dice_.between(0.0, kPi), direction()).toRotationMatrix();
  }
  return pose;
}

/// Of any order of magnitude in one of four, zero in one of eight.
double RandomShapes::length(double size) {
  const double chance = dice_.between(0.0, 1.0);
  if (chance < 0.125) return 0.0;
  if (chance < 0.375) return size * std::pow(10.0, dice_.between(-9.0, 0.0));
  return size * dice_.between(0.05, 1.0);
}

Shape RandomShapes::shape(Kind kind, double size, const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d half = 0.5 * length(size) * Eigen::Vector3d::UnitX();
  switch (kind) {
    case Kind::kCapsule:
      return Capsule{pose * half, pose * Eigen::Vector3d(-half), 0.3 * length(size)};
    case Kind::kBox:
      return Box{pose, 0.5 * Eigen::Vector3d(length(size), length(size), length(size))};
    default:
      // Shorter ones are balls by definition, which a test of their own shows.
      const Eigen::Vector3d axis = std::max(half.x(), kShortestCylinder) * Eigen::Vector3d::UnitX();
      return Cylinder{pose * axis, pose * Eigen::Vector3d(-axis), 0.5 * length(size)};
  }
}

Shape RandomShapes::shape(Kind kind, double size) { return shape(kind, size, pose(size)); }

Eigen::Vector3d RandomShapes::point_of(const Shape& shape) {
  const double share = dice_.between(0.0, 1.0);
  return share * farthest_point(shape, direction()) + (1.0 - share) * farthest_point(shape, direction());
}

std::pair<Shape, Shape> RandomShapes::pair(Kind first, Kind second, double size) {
  const Eigen::Isometry3d where = pose(size);
  const Shape some = shape(first, size, where);
  const double other_size = dice_.happens(0.3) ? size * std::pow(10.0, dice_.between(-3.0, 0.0)) : size;
  Eigen::Isometry3d there = pose(size);
  if (dice_.happens(0.3)) there.linear() = where.linear();
  if (dice_.happens(0.1)) {
    const double lean = std::pow(10.0, dice_.between(-12.0, -2.0));
    there.linear() = where.linear() * Eigen::AngleAxisd(lean, direction()).toRotationMatrix();
  }
  Shape other = shape(second, other_size, there);
  // Apart along one direction, by a plane between them; less than nothing is an overlap.
  const Eigen::Vector3d apart = dice_.happens(0.5) ? Eigen::Vector3d(where.linear().col(dice_.one_of(3))) : direction();
  double gap = size * std::pow(10.0, dice_.between(-10.0, 0.3));
  if (dice_.happens(0.1)) gap = -gap;
  if (dice_.happens(0.1)) gap = 0.0;
  const Eigen::Vector3d sideways = dice_.happens(0.5) ? Eigen::Vector3d::Zero() : Eigen::Vector3d(size * direction());
  const double room = apart.dot(farthest_point(some, apart) - farthest_point(other, -apart));
  const Eigen::Vector3d middles = centre(some) + sideways - centre(other);
  const Eigen::Vector3d across = middles - apart.dot(middles) * apart;
  other = placed(other, Eigen::Isometry3d(Eigen::Translation3d((room + gap) * apart + across)));
  if (dice_.happens(0.5)) return {other, some};
  return {some, other};
}

double rounding_of_rim(const Shape& shape) {
  const auto* cylinder = std::get_if<Cylinder>(&shape);
  return cylinder != nullptr ? 1e-11 * cylinder->radius / (cylinder->end - cylinder->start).norm() : 0.0;
}

}  // namespace dualarm
