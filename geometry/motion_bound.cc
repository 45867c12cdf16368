#include "geometry/motion_bound.h"

#include <algorithm>
#include <cmath>

#include "geometry/support.h"

namespace dualarm {
namespace {

/// Largest `measure` of a corner of the box; right for anything convex.
template <typename Measure>
double largest_of_corners(const Box& box, const Measure& measure) {
  double largest = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d signs((corner & 1) ? 1.0 : -1.0, (corner & 2) ? 1.0 : -1.0, (corner & 4) ? 1.0 : -1.0);
    largest = std::max(largest, measure(box.pose * box.half_extents.cwiseProduct(signs)));
  }
  return largest;
}

/// The rim of a disc seen along z is an ellipse: inside the circle of its radius, and inside the rectangle of its axes.
double reach_of_disc(const Eigen::Vector3d& middle, const Eigen::Vector3d& normal, double radius) {
  const Eigen::Vector2d flat = middle.head<2>();
  const double in_circle = flat.norm() + radius;
  const double lean = normal.head<2>().norm();
  if (lean == 0.0) return in_circle;
  const Eigen::Vector2d minor = normal.head<2>() / lean;
  const Eigen::Vector2d major = minor.unitOrthogonal();
  const double in_rectangle =
      std::hypot(std::abs(flat.dot(minor)) + radius * std::abs(normal.z()), std::abs(flat.dot(major)) + radius);
  return std::min(in_circle, in_rectangle);
}

struct Reach {
  double operator()(const Capsule& capsule) const {
    return std::max(capsule.start.head<2>().norm(), capsule.end.head<2>().norm()) + capsule.radius;
  }
  double operator()(const Box& box) const {
    return largest_of_corners(box, [](const Eigen::Vector3d& corner) { return corner.head<2>().norm(); });
  }
  double operator()(const Cylinder& cylinder) const {
    const Eigen::Vector3d axis = cylinder.end - cylinder.start;
    const double length = axis.norm();
    if (length < kShortestCylinder) return centre(cylinder).head<2>().norm() + bounding_radius(cylinder);
    const Eigen::Vector3d normal = axis / length;
    return std::max(reach_of_disc(cylinder.start, normal, cylinder.radius),
                    reach_of_disc(cylinder.end, normal, cylinder.radius));
  }
};

struct Extent {
  double operator()(const Capsule& capsule) const {
    return std::max(capsule.start.norm(), capsule.end.norm()) + capsule.radius;
  }
  double operator()(const Box& box) const {
    return largest_of_corners(box, [](const Eigen::Vector3d& corner) { return corner.norm(); });
  }
  double operator()(const Cylinder& cylinder) const {
    const Eigen::Vector3d axis = cylinder.end - cylinder.start;
    const double length = axis.norm();
    if (length < kShortestCylinder) return centre(cylinder).norm() + bounding_radius(cylinder);
    const auto of_disc = [&](const Eigen::Vector3d& middle) {
      const double along = middle.dot(axis) / length;
      return std::hypot(along, (middle - along * axis / length).norm() + cylinder.radius);
    };
    return std::max(of_disc(cylinder.start), of_disc(cylinder.end));
  }
};

}  // namespace

double reach(const Shape& in_link_frame) { return std::visit(Reach{}, in_link_frame); }

double extent(const Shape& in_its_frame) { return std::visit(Extent{}, in_its_frame); }

double swept_gap(const Base& base, const Shape& in_link_frame, const Shape& standing) {
  const Eigen::Vector3d from_joint = centre(standing) - base.position;
  const double beside = from_joint.head<2>().norm() - reach(in_link_frame);
  const double above = from_joint.z() - farthest_point(in_link_frame, Eigen::Vector3d::UnitZ()).z();
  const double below = farthest_point(in_link_frame, -Eigen::Vector3d::UnitZ()).z() - from_joint.z();
  return std::hypot(std::max(beside, 0.0), std::max({above, below, 0.0})) - bounding_radius(standing);
}

}  // namespace dualarm
