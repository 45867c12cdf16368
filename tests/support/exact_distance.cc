#include "tests/support/exact_distance.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>

namespace dualarm {
namespace {

using Point = Eigen::Matrix<long double, 3, 1>;

long double point_to_segment(const Point& point, const Point& start, const Point& end) {
  const Point along = end - start;
  const long double square = along.squaredNorm();
  const long double fraction = square > 0.0L ? std::clamp((point - start).dot(along) / square, 0.0L, 1.0L) : 0.0L;
  return (point - start - fraction * along).norm();
}

}  // namespace

long double exact_distance(const Capsule& first, const Capsule& second) {
  const Point a = first.start.cast<long double>();
  const Point b = first.end.cast<long double>();
  const Point c = second.start.cast<long double>();
  const Point d = second.end.cast<long double>();
  long double axes = std::min(std::min(point_to_segment(a, c, d), point_to_segment(b, c, d)),
                              std::min(point_to_segment(c, a, b), point_to_segment(d, a, b)));
  const Point across = (b - a).cross(d - c);
  const long double square = across.squaredNorm();
  if (square > 0.0L) {
    const long double on_first = (c - a).cross(d - c).dot(across) / square;
    const long double on_second = (c - a).cross(b - a).dot(across) / square;
    const bool is_inside = on_first >= 0.0L && on_first <= 1.0L && on_second >= 0.0L && on_second <= 1.0L;
    if (is_inside) axes = std::min(axes, std::abs((c - a).dot(across)) / std::sqrt(square));
  }
  return axes - first.radius - second.radius;
}

}  // namespace dualarm
