#pragma once

#include <Eigen/Core>
#include <array>

namespace dualarm {

/// A segment in the plane, m.
struct Segment {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
};

/// A point, a segment, a triangle or a convex quadrangle with its inside: one to four corners in the plane, m, no two
/// alike, counterclockwise.
struct Outline {
  std::array<Eigen::Vector2d, 4> corners = {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(),
                                            Eigen::Vector2d::Zero()};
  int count = 1;
};

/// A segment, or the point it is where it has no length.
Outline outline_of(const Segment& segment);

/// Reflected in the x axis.
Outline mirrored(const Outline& outline);

/// A direction of the plane as cosine and sine.
struct Heading {
  double cosine = 1.0;
  double sine = 0.0;

  Eigen::Vector2d turn(const Eigen::Vector2d& v) const {
    return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
  }
};

Heading heading_of(double angle);

/// An outline with the directions of its edges, which a move only turns.
struct Figure {
  Outline outline;
  std::array<Eigen::Vector2d, 4> along = {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(),
                                          Eigen::Vector2d::Zero()};  ///< unit vectors, the outside to their right
  std::array<double, 4> length = {};                                 ///< m, of the edges

  /// A segment has one edge, what has an inside as many as corners.
  int edge_count() const { return outline.count < 3 ? outline.count - 1 : outline.count; }
};

Figure figure_of(const Outline& outline);

/// Turned about the origin, then shifted.
Figure moved(const Figure& figure, const Heading& heading, const Eigen::Vector2d& shift);

/// Where two figures are nearest.
struct Nearest {
  enum class Flank { kNone, kOfFirst, kOfSecond };

  double distance = 0.0;                             ///< m, 0 where they overlap: the rest is void then
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();  ///< from the first towards the second
  Flank flank = Flank::kNone;                        ///< whether the nearest point lies inside an edge of one
};

Nearest nearest(const Figure& first, const Figure& second);

/// Whether two figures are closer than or as close as a distance (m, >= 0).
bool are_within(const Figure& first, const Figure& second, double distance);

/// Distance (m) between a point and a figure, 0 inside it.
double point_distance(const Eigen::Vector2d& point, const Figure& figure);

/// Distance (m) between two outlines, 0 where they overlap.
double outline_distance(const Outline& first, const Outline& second);

/// Distance (m) between two segments of the plane, 0 where they cross.
double segment_distance(const Segment& first, const Segment& second);

}  // namespace dualarm
