#include "tests/support/exact_distance.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace dualarm {
namespace {

using Point = Eigen::Matrix<long double, 3, 1>;

long double point_to_segment(const Point& point, const Point& start, const Point& end) {
  const Point along = end - start;
  const long double square = along.squaredNorm();
  const long double fraction = square > 0.0L ? std::clamp((point - start).dot(along) / square, 0.0L, 1.0L) : 0.0L;
  return (point - start - fraction * along).norm();
}

/// Everything without round parts: a box, whose half extents may be 0.
struct Block {
  Point centre;
  Eigen::Matrix<long double, 3, 3> axes;
  Point half;

  Point corner(int i) const {
    return centre +
           axes * Point((i & 1) ? half.x() : -half.x(), (i & 2) ? half.y() : -half.y(), (i & 4) ? half.z() : -half.z());
  }
  long double distance_to(const Point& point) const {
    const Point local = axes.transpose() * (point - centre);
    return (local.cwiseAbs() - half).cwiseMax(0.0L).norm();
  }
};

struct Tube {
  Point centre;
  Point axis;
  long double half;
  long double radius;

  long double distance_to(const Point& point) const {
    const Point from_centre = point - centre;
    const long double along = from_centre.dot(axis);
    return std::hypot(std::max(0.0L, std::abs(along) - half),
                      std::max(0.0L, (from_centre - along * axis).norm() - radius));
  }
};

/// Two directions across a unit vector.
std::array<Point, 2> across(const Point& axis) {
  const Point first = axis.unitOrthogonal();
  return {first, axis.cross(first)};
}

Block block_of(const Capsule& capsule) {
  const Point start = capsule.start.cast<long double>();
  const Point end = capsule.end.cast<long double>();
  Block block = {0.5L * (start + end), Eigen::Matrix<long double, 3, 3>::Identity(), Point::Zero()};
  const long double length = (end - start).norm();
  if (length == 0.0L) return block;
  const Point axis = (end - start) / length;
  block.axes << axis, across(axis)[0], across(axis)[1];
  block.half.x() = 0.5L * length;
  return block;
}

Block block_of(const Box& box) {
  return {box.pose.translation().cast<long double>(), box.pose.linear().cast<long double>(),
          box.half_extents.cast<long double>()};
}

Tube tube_of(const Cylinder& cylinder) {
  const Point start = cylinder.start.cast<long double>();
  const Point end = cylinder.end.cast<long double>();
  const long double length = (end - start).norm();
  return {0.5L * (start + end), (end - start) / length, 0.5L * length, cylinder.radius};
}

long double segment_to_segment(const Point& a, const Point& b, const Point& c, const Point& d) {
  long double least = std::min(std::min(point_to_segment(a, c, d), point_to_segment(b, c, d)),
                               std::min(point_to_segment(c, a, b), point_to_segment(d, a, b)));
  const Point normal = (b - a).cross(d - c);
  const long double square = normal.squaredNorm();
  if (square > 0.0L) {
    const long double on_first = (c - a).cross(d - c).dot(normal) / square;
    const long double on_second = (c - a).cross(b - a).dot(normal) / square;
    const bool is_inside = on_first >= 0.0L && on_first <= 1.0L && on_second >= 0.0L && on_second <= 1.0L;
    if (is_inside) least = std::min(least, std::abs((c - a).dot(normal)) / std::sqrt(square));
  }
  return least;
}

/// The theorem of the separating axis: faces of either, and edges crossed.
bool overlap(const Block& first, const Block& second) {
  std::vector<Point> candidates;
  for (int i = 0; i < 3; ++i) {
    candidates.push_back(first.axes.col(i));
    candidates.push_back(second.axes.col(i));
    for (int j = 0; j < 3; ++j) candidates.push_back(first.axes.col(i).cross(second.axes.col(j)));
  }
  const auto width = [](const Block& block, const Point& direction) {
    return (block.axes.transpose() * direction).cwiseAbs().dot(block.half);
  };
  return std::none_of(candidates.begin(), candidates.end(), [&](const Point& axis) {
    return std::abs(axis.dot(second.centre - first.centre)) > width(first, axis) + width(second, axis);
  });
}

long double distance(const Block& first, const Block& second) {
  if (overlap(first, second)) return 0.0L;
  long double least = first.distance_to(second.centre);
  constexpr std::array<int, 3> kDirections = {1, 2, 4};
  for (int i = 0; i < 8; ++i) {
    least = std::min({least, first.distance_to(second.corner(i)), second.distance_to(first.corner(i))});
    for (int j = 0; j < 8; ++j) {
      for (const int along : kDirections) {
        for (const int over : kDirections) {
          if ((i & along) != 0 || (j & over) != 0) continue;
          least = std::min(least, segment_to_segment(first.corner(i), first.corner(i | along), second.corner(j),
                                                     second.corner(j | over)));
        }
      }
    }
  }
  return least;
}

/// Least value of a convex function on [low, high] by the golden section, and no more than at the ends.
template <typename Function>
long double least_of(long double low, long double high, const Function& function) {
  if (low >= high) return function(low);
  constexpr long double kGolden = 0.618033988749894848204586834L;
  long double best = std::min(function(low), function(high));
  long double left = high - kGolden * (high - low);
  long double right = low + kGolden * (high - low);
  long double at_left = function(left);
  long double at_right = function(right);
  for (int step = 0; step < 62; ++step) {
    best = std::min({best, at_left, at_right});
    if (at_left < at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - kGolden * (high - low);
      at_left = function(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + kGolden * (high - low);
      at_right = function(right);
    }
  }
  return best;
}

/// The least distance is that of a point of the block; unless they overlap one of a face.
long double distance(const Tube& tube, const Block& block) {
  return least_of(-block.half.x(), block.half.x(), [&](long double x) {
    return least_of(-block.half.y(), block.half.y(), [&](long double y) {
      return least_of(-block.half.z(), block.half.z(),
                      [&](long double z) { return tube.distance_to(block.centre + block.axes * Point(x, y, z)); });
    });
  });
}

long double distance(const Tube& first, const Tube& second) {
  const auto [u, v] = across(second.axis);
  return least_of(-second.half, second.half, [&](long double along) {
    return least_of(-second.radius, second.radius, [&](long double x) {
      const long double room = std::sqrt(second.radius * second.radius - x * x);
      return least_of(-room, room, [&](long double y) {
        return first.distance_to(second.centre + along * second.axis + x * u + y * v);
      });
    });
  });
}

long double distance(const Block& block, const Tube& tube) { return distance(tube, block); }

struct CoreDistance {
  template <typename First, typename Second>
  long double operator()(const First& first, const Second& second) const {
    return distance(core(first), core(second));
  }
  static Block core(const Capsule& capsule) { return block_of(capsule); }
  static Block core(const Box& box) { return block_of(box); }
  static Tube core(const Cylinder& cylinder) { return tube_of(cylinder); }
};

/// How far a shape reaches in a unit direction, measured from the world's origin.
struct Farthest {
  Point direction;

  long double operator()(const Capsule& capsule) const {
    return std::max(capsule.start.cast<long double>().dot(direction), capsule.end.cast<long double>().dot(direction)) +
           capsule.radius;
  }
  long double operator()(const Box& box) const {
    const Block block = block_of(box);
    return block.centre.dot(direction) + (block.axes.transpose() * direction).cwiseAbs().dot(block.half);
  }
  long double operator()(const Cylinder& cylinder) const {
    const Tube tube = tube_of(cylinder);
    return tube.centre.dot(direction) + tube.half * std::abs(tube.axis.dot(direction)) +
           tube.radius * tube.axis.cross(direction).norm();
  }
};

long double rounding(const Shape& shape) {
  const auto* capsule = std::get_if<Capsule>(&shape);
  return capsule != nullptr ? static_cast<long double>(capsule->radius) : 0.0L;
}

}  // namespace

long double exact_distance(const Capsule& first, const Capsule& second) {
  const long double axes = segment_to_segment(first.start.cast<long double>(), first.end.cast<long double>(),
                                              second.start.cast<long double>(), second.end.cast<long double>());
  return axes - first.radius - second.radius;
}

long double exact_distance(const Shape& first, const Shape& second) {
  if (std::holds_alternative<Capsule>(first) && std::holds_alternative<Capsule>(second)) {
    return exact_distance(std::get<Capsule>(first), std::get<Capsule>(second));
  }
  return std::visit(CoreDistance{}, first, second) - rounding(first) - rounding(second);
}

long double proven_distance(const Shape& first, const Shape& second, const Eigen::Vector3d& direction) {
  const Point normal = direction.cast<long double>().normalized();
  return -std::visit(Farthest{-normal}, first) - std::visit(Farthest{normal}, second);
}

}  // namespace dualarm
