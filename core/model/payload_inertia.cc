#include "core/model/payload_inertia.h"

#include "geometry/support.h"

namespace dualarm {
namespace {

double squared(double value) { return value * value; }

/// Of a body of revolution about its centre, from its moments about its axis and across it (any unit).
double leaning(const Eigen::Vector3d& axis, double about_axis, double across_axis) {
  const double length = axis.norm();
  const double upright = length > 0.0 ? squared(axis.z() / length) : 0.0;
  return upright * about_axis + (1.0 - upright) * across_axis;
}

/// Moment of inertia of unit mass about the z direction through the centre of the shape, m2.
struct AboutCentre {
  /// A rod with half a ball on either end.
  double operator()(const Capsule& capsule) const {
    const Eigen::Vector3d axis = capsule.end - capsule.start;
    const double length = axis.norm();
    const double r = capsule.radius;
    const double balls = r > 0.0 ? 4.0 * r / (4.0 * r + 3.0 * length) : 0.0;
    const double about_axis = (1.0 - balls) * 0.5 * r * r + balls * 0.4 * r * r;
    const double across_axis = (1.0 - balls) * (length * length / 12.0 + r * r / 4.0) +
                               balls * (0.4 * r * r + 0.375 * r * length + 0.25 * length * length);
    return leaning(axis, about_axis, across_axis);
  }
  double operator()(const Box& box) const {
    const Eigen::Vector3d squares = box.half_extents.cwiseAbs2();
    const Eigen::Vector3d about_edges = (Eigen::Vector3d::Constant(squares.sum()) - squares) / 3.0;
    return box.pose.linear().row(2).cwiseAbs2().dot(about_edges.transpose());
  }
  double operator()(const Cylinder& cylinder) const {
    const Eigen::Vector3d axis = cylinder.end - cylinder.start;
    const double r = cylinder.radius;
    return leaning(axis, 0.5 * r * r, 0.25 * r * r + axis.squaredNorm() / 12.0);
  }
};

}  // namespace

double payload_inertia(const Shape& in_link, double mass) {
  return mass * (std::visit(AboutCentre{}, in_link) + centre(in_link).head<2>().squaredNorm());
}

}  // namespace dualarm
