#include "geometry/support.h"

#include <algorithm>
#include <cmath>

namespace dualarm {
namespace {

template <typename Kind>
const Eigen::Vector3d& farther_end(const Kind& shape, const Eigen::Vector3d& direction) {
  return direction.dot(shape.end - shape.start) >= 0.0 ? shape.end : shape.start;
}

double squared(double value) { return value * value; }

struct FarthestPoint {
  Eigen::Vector3d direction;

  Eigen::Vector3d ball(const Eigen::Vector3d& middle, double radius) const {
    return radius > 0.0 ? Eigen::Vector3d(middle + radius * direction.stableNormalized()) : middle;
  }
  Eigen::Vector3d operator()(const Capsule& capsule) const {
    return ball(farther_end(capsule, direction), capsule.radius);
  }
  Eigen::Vector3d operator()(const Box& box) const {
    const Eigen::Vector3d local = box.pose.linear().transpose() * direction;
    const Eigen::Vector3d corner = (local.array() >= 0.0).select(box.half_extents, -box.half_extents);
    return box.pose * corner;
  }
  Eigen::Vector3d operator()(const Cylinder& cylinder) const {
    const Eigen::Vector3d axis = cylinder.end - cylinder.start;
    const double length = axis.norm();
    if (length < kShortestCylinder) return ball(centre(cylinder), std::hypot(cylinder.radius, 0.5 * length));
    const Eigen::Vector3d unit = axis / length;
    const Eigen::Vector3d roughly = direction - unit.dot(direction) * unit;
    // Once more: what is left of a direction almost along the axis is rounding, and that need not be across.
    const Eigen::Vector3d across = roughly - unit.dot(roughly) * unit;
    const double width = across.norm();
    // Straight along the axis any point of the rim does.
    const Eigen::Vector3d outwards = width > 0.0 ? Eigen::Vector3d(across / width) : unit.unitOrthogonal();
    return farther_end(cylinder, direction) + cylinder.radius * outwards;
  }
};

}  // namespace

Eigen::Vector3d farthest_point(const Shape& shape, const Eigen::Vector3d& direction) {
  return std::visit(FarthestPoint{direction}, shape);
}

Eigen::Vector3d centre(const Shape& shape) {
  struct Centre {
    Eigen::Vector3d operator()(const Capsule& capsule) const { return 0.5 * (capsule.start + capsule.end); }
    Eigen::Vector3d operator()(const Box& box) const { return box.pose.translation(); }
    Eigen::Vector3d operator()(const Cylinder& cylinder) const { return 0.5 * (cylinder.start + cylinder.end); }
  };
  return std::visit(Centre{}, shape);
}

double bounding_radius(const Shape& shape) {
  struct Radius {
    double operator()(const Capsule& capsule) const {
      return 0.5 * (capsule.end - capsule.start).norm() + capsule.radius;
    }
    double operator()(const Box& box) const { return box.half_extents.norm(); }
    double operator()(const Cylinder& cylinder) const {
      return std::sqrt(0.25 * (cylinder.end - cylinder.start).squaredNorm() + squared(cylinder.radius));
    }
  };
  return std::visit(Radius{}, shape);
}

double distance_to_ball(const Shape& shape, const Eigen::Vector3d& middle, double radius) {
  const auto* capsule = std::get_if<Capsule>(&shape);
  if (capsule == nullptr) return (middle - centre(shape)).norm() - bounding_radius(shape) - radius;
  const Eigen::Vector3d axis = capsule->end - capsule->start;
  const double square = axis.squaredNorm();
  const double share = square > 0.0 ? std::clamp((middle - capsule->start).dot(axis) / square, 0.0, 1.0) : 0.0;
  return (middle - capsule->start - share * axis).norm() - capsule->radius - radius;
}

}  // namespace dualarm
