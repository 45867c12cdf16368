#include "geometry/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/plane.h"

namespace dualarm {
namespace {

/// How a point lies to an edge: the way from the nearest point of the edge, and whether that is inside it.
struct Beside {
  Eigen::Vector2d way;
  bool is_flank;
};

Beside beside(const Eigen::Vector2d& point, const Figure& figure, int edge) {
  const Eigen::Vector2d from_start = point - figure.outline.corners[edge];
  const double share = from_start.dot(figure.along[edge]);
  const double nearest = std::clamp(share, 0.0, figure.length[edge]);
  return {from_start - nearest * figure.along[edge], nearest == share};
}

double distance_squared(const Eigen::Vector2d& point, const Figure& figure, int edge) {
  return beside(point, figure, edge).way.squaredNorm();
}

/// Whether a point lies in what has an inside.
bool contains(const Figure& figure, const Eigen::Vector2d& point) {
  if (figure.outline.count < 3) return false;
  for (int i = 0; i < figure.outline.count; ++i) {
    if (cross(figure.along[i], point - figure.outline.corners[i]) < 0.0) return false;
  }
  return true;
}

bool is_within(const Eigen::Vector2d& point, const Figure& figure, double square) {
  if (figure.outline.count == 1) return (point - figure.outline.corners[0]).squaredNorm() <= square;
  for (int i = 0; i < figure.edge_count(); ++i) {
    if (distance_squared(point, figure, i) <= square) return true;
  }
  return contains(figure, point);
}

bool cross_each_other(const Figure& first, int i, const Figure& second, int k) {
  const auto on_both_sides = [](const Figure& line, int edge, const Figure& of, int other) {
    const Eigen::Vector2d start = of.outline.corners[other] - line.outline.corners[edge];
    const double side = cross(line.along[edge], start);
    return side * (side + of.length[other] * cross(line.along[edge], of.along[other])) < 0.0;
  };
  return on_both_sides(first, i, second, k) && on_both_sides(second, k, first, i);
}

bool have_crossing_edges(const Figure& first, const Figure& second) {
  for (int i = 0; i < first.edge_count(); ++i) {
    for (int k = 0; k < second.edge_count(); ++k) {
      if (cross_each_other(first, i, second, k)) return true;
    }
  }
  return false;
}

/// The nearest of the corners of one figure to another one; `towards` 1 if the corners are the second figure's.
void improve(Nearest& best, const Figure& figure, const Figure& corners, double towards, Nearest::Flank flank) {
  for (int k = 0; k < corners.outline.count; ++k) {
    const Eigen::Vector2d& corner = corners.outline.corners[k];
    const auto take = [&](const Eigen::Vector2d& way, bool is_flank) {
      const double distance = way.norm();
      if (!(distance < best.distance)) return;
      best = {distance, towards * way, is_flank ? flank : Nearest::Flank::kNone};
    };
    if (figure.outline.count == 1) take(corner - figure.outline.corners[0], false);
    for (int i = 0; i < figure.edge_count(); ++i) {
      const Beside at = beside(corner, figure, i);
      take(at.way, at.is_flank);
    }
    if (contains(figure, corner)) best.distance = 0.0;
  }
}

}  // namespace

Outline outline_of(const Segment& segment) {
  Outline outline;
  outline.corners[0] = segment.start;
  outline.corners[1] = segment.end;
  outline.count = segment.start == segment.end ? 1 : 2;
  return outline;
}

Outline mirrored(const Outline& outline) {
  Outline result;
  result.count = outline.count;
  for (int i = 0; i < outline.count; ++i) {
    const Eigen::Vector2d& corner = outline.corners[outline.count - 1 - i];
    result.corners[i] = {corner.x(), -corner.y()};
  }
  return result;
}

Heading heading_of(double angle) { return {std::cos(angle), std::sin(angle)}; }

Figure figure_of(const Outline& outline) {
  Figure figure;
  figure.outline = outline;
  for (int i = 0; i < figure.edge_count(); ++i) {
    const Eigen::Vector2d way = outline.corners[(i + 1) % outline.count] - outline.corners[i];
    figure.length[i] = way.norm();
    figure.along[i] = way / figure.length[i];
  }
  return figure;
}

Figure moved(const Figure& figure, const Heading& heading, const Eigen::Vector2d& shift) {
  Figure result;
  result.outline.count = figure.outline.count;
  for (int i = 0; i < figure.outline.count; ++i) {
    result.outline.corners[i] = heading.turn(figure.outline.corners[i]) + shift;
  }
  for (int i = 0; i < figure.edge_count(); ++i) {
    result.along[i] = heading.turn(figure.along[i]);
    result.length[i] = figure.length[i];
  }
  return result;
}

Nearest nearest(const Figure& first, const Figure& second) {
  Nearest best;
  if (have_crossing_edges(first, second)) return best;
  best.distance = std::numeric_limits<double>::infinity();
  improve(best, first, second, 1.0, Nearest::Flank::kOfFirst);
  improve(best, second, first, -1.0, Nearest::Flank::kOfSecond);
  if (best.distance > 0.0) best.normal /= best.distance;
  return best;
}

bool are_within(const Figure& first, const Figure& second, double distance) {
  const double square = distance * distance;
  for (int i = 0; i < first.outline.count; ++i) {
    if (is_within(first.outline.corners[i], second, square)) return true;
  }
  for (int i = 0; i < second.outline.count; ++i) {
    if (is_within(second.outline.corners[i], first, square)) return true;
  }
  return have_crossing_edges(first, second);
}

double point_distance(const Eigen::Vector2d& point, const Figure& figure) {
  if (contains(figure, point)) return 0.0;
  if (figure.outline.count == 1) return (point - figure.outline.corners[0]).norm();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < figure.edge_count(); ++i) least = std::min(least, distance_squared(point, figure, i));
  return std::sqrt(least);
}

double outline_distance(const Outline& first, const Outline& second) {
  return nearest(figure_of(first), figure_of(second)).distance;
}

double segment_distance(const Segment& first, const Segment& second) {
  return outline_distance(outline_of(first), outline_of(second));
}

}  // namespace dualarm
