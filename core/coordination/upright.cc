#include "core/coordination/upright.h"

#include <algorithm>
#include <cmath>

#include "geometry/support.h"

namespace dualarm {
namespace {

Outline short_of(const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
  const Eigen::Vector2d a = start.head<2>();
  const Eigen::Vector2d b = end.head<2>();
  return (b - a).norm() > kLean ? outline_of({a, b}) : outline_of({0.5 * (a + b), 0.5 * (a + b)});
}

Interval heights_of(const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
  return {std::min(start.z(), end.z()), std::max(start.z(), end.z())};
}

/// The parallelogram around a middle with two half edges, either of which may be nothing.
Outline outline_around(const Eigen::Vector2d& middle, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  if (a.norm() <= kLean || b.norm() <= kLean) {
    const Eigen::Vector2d longer = a.norm() < b.norm() ? b : a;
    if (longer.norm() <= kLean) return outline_of({middle, middle});
    return outline_of({middle - longer, middle + longer});
  }
  Outline outline;
  outline.corners = {middle - a - b, middle + a - b, middle + a + b, middle - a + b};
  outline.count = 4;
  if (a.x() * b.y() - a.y() * b.x() < 0.0) std::swap(outline.corners[1], outline.corners[3]);
  return outline;
}

struct ToUpright {
  std::optional<Upright> operator()(const Capsule& capsule) const {
    const Eigen::Vector3d along = capsule.end - capsule.start;
    if (std::min(along.head<2>().norm(), std::abs(along.z())) > kLean) return std::nullopt;
    return Upright{short_of(capsule.start, capsule.end), heights_of(capsule.start, capsule.end), 0.0, capsule.radius};
  }

  std::optional<Upright> operator()(const Box& box) const {
    const Eigen::Matrix3d half_edges = box.pose.linear() * box.half_extents.asDiagonal();
    for (int up = 0; up < 3; ++up) {
      const int i = (up + 1) % 3;
      const int k = (up + 2) % 3;
      if (half_edges.col(up).head<2>().norm() > kLean || std::abs(half_edges(2, i)) > kLean ||
          std::abs(half_edges(2, k)) > kLean) {
        continue;
      }
      const double height = half_edges.row(2).cwiseAbs().sum();
      const Eigen::Vector3d middle = box.pose.translation();
      return Upright{outline_around(middle.head<2>(), half_edges.col(i).head<2>(), half_edges.col(k).head<2>()),
                     {middle.z() - height, middle.z() + height},
                     0.0,
                     0.0};
    }
    return std::nullopt;
  }

  std::optional<Upright> operator()(const Cylinder& cylinder) const {
    const Eigen::Vector3d along = cylinder.end - cylinder.start;
    const double length = along.norm();
    if (length < kShortestCylinder) {
      return (*this)(Capsule{centre(cylinder), centre(cylinder), bounding_radius(cylinder)});
    }
    if (cylinder.radius == 0.0) return (*this)(Capsule{cylinder.start, cylinder.end, 0.0});
    const double lean = along.head<2>().norm();
    if (std::max(lean, lean / length * cylinder.radius) > kLean) return std::nullopt;
    return Upright{short_of(cylinder.start, cylinder.end), heights_of(cylinder.start, cylinder.end), cylinder.radius,
                   0.0};
  }
};

}  // namespace

std::optional<Upright> upright(const Shape& shape) { return std::visit(ToUpright{}, shape); }

double distance_in_plane(const Upright& first, const Upright& second, double lift, double distance) {
  const double height = std::max(
      {0.0, first.heights.lower + lift - second.heights.upper, second.heights.lower - first.heights.upper - lift});
  const double of_cores = distance + first.round + second.round;
  if (of_cores < height) return -1.0;
  return first.radius + second.radius + std::sqrt((of_cores - height) * (of_cores + height));
}

}  // namespace dualarm
