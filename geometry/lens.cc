#include "geometry/lens.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace dualarm {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double point_distance(const Eigen::Vector2d& point, const Segment& segment) {
  const Eigen::Vector2d along = segment.end - segment.start;
  const double length_squared = along.squaredNorm();
  const double share =
      length_squared > 0.0 ? std::clamp((point - segment.start).dot(along) / length_squared, 0.0, 1.0) : 0.0;
  return (point - segment.start - share * along).norm();
}

bool cross_each_other(const Segment& a, const Segment& b) {
  const Eigen::Vector2d along_a = a.end - a.start;
  const Eigen::Vector2d along_b = b.end - b.start;
  const bool b_on_both_sides = cross(along_a, b.start - a.start) * cross(along_a, b.end - a.start) < 0.0;
  const bool a_on_both_sides = cross(along_b, a.start - b.start) * cross(along_b, a.end - b.start) < 0.0;
  return b_on_both_sides && a_on_both_sides;
}

/// A segment has one edge, what has an inside as many as corners.
int edge_count(const Outline& outline) { return outline.count < 3 ? outline.count - 1 : outline.count; }

Segment edge(const Outline& outline, int index) {
  return {outline.corners[index], outline.corners[(index + 1) % outline.count]};
}

/// Whether a point lies in what has an inside.
bool contains(const Outline& outline, const Eigen::Vector2d& point) {
  if (outline.count < 3) return false;
  for (int i = 0; i < outline.count; ++i) {
    const Segment side = edge(outline, i);
    if (cross(side.end - side.start, point - side.start) < 0.0) return false;
  }
  return true;
}

double point_distance(const Eigen::Vector2d& point, const Outline& outline) {
  if (contains(outline, point)) return 0.0;
  if (outline.count == 1) return (point - outline.corners[0]).norm();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < edge_count(outline); ++i) least = std::min(least, point_distance(point, edge(outline, i)));
  return least;
}

double largest_radius(const Outline& outline) {
  double largest = 0.0;
  for (int i = 0; i < outline.count; ++i) largest = std::max(largest, outline.corners[i].norm());
  return largest;
}

Outline turned(Outline outline, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (int i = 0; i < outline.count; ++i) {
    const Eigen::Vector2d p = outline.corners[i];
    outline.corners[i] = {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
  }
  return outline;
}

/// Part of the size of a scene by which a contact may lie beyond the end of its flank or cap and still count: more than
/// rounding. One too many costs a test, one too few the truth.
constexpr double kBeyondEnd = 1e-9;

/// An edge as a line: where it lies across and along its direction.
struct Line {
  Eigen::Vector2d along;
  Eigen::Vector2d outwards;  ///< to its right, which is the outside
  double off;                ///< m, of the origin inwards
  Interval extent;           ///< m, along
};

Line line_of(const Segment& edge) {
  const Eigen::Vector2d along = (edge.end - edge.start).normalized();
  const Eigen::Vector2d outwards(along.y(), -along.x());
  return {along, outwards, outwards.dot(edge.start), {along.dot(edge.start), along.dot(edge.end)}};
}

/// The angles by which a corner has to be turned about the origin to come to lie at a distance from an outline, each a
/// contact with a flank or with the cap around a corner.
class Contacts {
 public:
  Contacts(double distance, double size) : distance_(distance), beyond_(kBeyondEnd * size) {}

  /// Of corners with the flanks of an outline. `sense` -1 where it is the outline that turns.
  void add_flanks(const Outline& outline, const Outline& corners, double sense) {
    for (int i = 0; i < edge_count(outline); ++i) {
      const Line line = line_of(edge(outline, i));
      for (int k = 0; k < corners.count; ++k) {
        const Turn turn = {corners.corners[k], corners.corners[k].norm(), sense};
        if (turn.radius == 0.0) continue;
        add_flank(line, distance_, turn);
        if (outline.count == 2) add_flank(line, -distance_, turn);
      }
    }
  }

  /// Of corners with the caps around the corners of an outline.
  void add_caps(const Outline& outline, const Outline& corners) {
    for (int k = 0; k < corners.count; ++k) {
      const Turn turn = {corners.corners[k], corners.corners[k].norm(), 1.0};
      for (int i = 0; turn.radius > 0.0 && i < outline.count; ++i) add_cap(outline, i, turn);
    }
  }

  /// All of them within one turn above `from`, ascending, with the turn's two ends.
  std::span<const double> within_turn_above(double from) {
    for (int i = 0; i < count_; ++i) {
      double& angle = angles_[i];
      angle = from + std::fmod(std::fmod(angle - from, kTurn) + kTurn, kTurn);
    }
    angles_[count_++] = from;
    angles_[count_++] = from + kTurn;
    std::sort(angles_.begin(), angles_.begin() + count_);
    return {angles_.data(), static_cast<std::size_t>(count_)};
  }

 private:
  struct Turn {
    Eigen::Vector2d corner;
    double radius;
    double sense;
  };

  /// From where the corner is to a place as far from the origin.
  void add(const Eigen::Vector2d& place, const Turn& turn) {
    angles_[count_++] = turn.sense * std::atan2(cross(turn.corner, place), turn.corner.dot(place));
  }

  /// The line beside an edge meets the circle of the corner twice.
  void add_flank(const Line& line, double distance, const Turn& turn) {
    const double off = line.off + distance;
    if (!(std::abs(off) <= turn.radius)) return;
    const double chord = std::sqrt((turn.radius - off) * (turn.radius + off));
    const Interval extent = {line.extent.lower - beyond_, line.extent.upper + beyond_};
    for (const double share : {-chord, chord}) {
      if (extent.contains(share)) add(off * line.outwards + share * line.along, turn);
    }
  }

  /// The circle around a corner of the outline meets that of the turned corner twice.
  void add_cap(const Outline& outline, int index, const Turn& turn) {
    const Eigen::Vector2d& middle = outline.corners[index];
    const double away = middle.norm();
    if (away == 0.0) return;
    const double cosine =
        (turn.radius * turn.radius + away * away - distance_ * distance_) / (2.0 * turn.radius * away);
    if (!(std::abs(cosine) <= 1.0)) return;
    const Eigen::Vector2d towards = middle / away;
    const Eigen::Vector2d across(-towards.y(), towards.x());
    const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
    for (const double side : {-sine, sine}) {
      const Eigen::Vector2d place = turn.radius * (cosine * towards + side * across);
      if (is_beside_corner(outline, index, place)) add(place, turn);
    }
  }

  /// Whether a corner is what of the outline is nearest to a place outside.
  bool is_beside_corner(const Outline& outline, int index, const Eigen::Vector2d& place) const {
    const Eigen::Vector2d& corner = outline.corners[index];
    for (int i = 0; i < outline.count; ++i) {
      if (i == index || (outline.count == 4 && i == (index + 2) % 4)) continue;
      if ((place - corner).dot((outline.corners[i] - corner).normalized()) > beyond_) return false;
    }
    return true;
  }

  /// Four corners against four flanks or caps, and the other way round for flanks, two angles each; and two ends.
  static constexpr int kMost = 2 * (3 * 4 * 4) + 2;

  double distance_;
  double beyond_;
  std::array<double, kMost> angles_;
  int count_ = 0;
};

/// Pieces closer than this (rad) are one: the same cut, computed twice.
constexpr double kSeam = 1e-13;

void append(std::vector<Interval>& intervals, Interval next) {
  if (!intervals.empty() && next.lower <= intervals.back().upper + kSeam) {
    intervals.back().upper = std::max(intervals.back().upper, next.upper);
  } else {
    intervals.push_back(next);
  }
}

/// The intervals of the first turn of `window`, repeated for every turn that it meets, cut to it.
std::vector<Interval> unrolled(const std::vector<Interval>& one_turn, Interval window) {
  std::vector<Interval> result;
  const int turns = 1 + static_cast<int>(window.length() / kTurn);
  for (int turn = 0; turn < turns; ++turn) {
    const double shift = turn * kTurn;
    for (const Interval& piece : one_turn) {
      const Interval cut = {std::max(piece.lower + shift, window.lower), std::min(piece.upper + shift, window.upper)};
      if (!cut.empty()) append(result, cut);
    }
  }
  return result;
}

}  // namespace

Outline outline_of(const Segment& segment) {
  Outline outline;
  outline.corners[0] = segment.start;
  outline.corners[1] = segment.end;
  outline.count = segment.start == segment.end ? 1 : 2;
  return outline;
}

double outline_distance(const Outline& first, const Outline& second) {
  for (int i = 0; i < edge_count(first); ++i) {
    for (int k = 0; k < edge_count(second); ++k) {
      if (cross_each_other(edge(first, i), edge(second, k))) return 0.0;
    }
  }
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < first.count; ++i) least = std::min(least, point_distance(first.corners[i], second));
  for (int i = 0; i < second.count; ++i) least = std::min(least, point_distance(second.corners[i], first));
  return least;
}

double segment_distance(const Segment& first, const Segment& second) {
  return outline_distance(outline_of(first), outline_of(second));
}

std::vector<Interval> colliding_angles(const Outline& fixed, const Outline& turning, double distance, Interval window) {
  const Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  const double reach = largest_radius(turning);
  const double away = largest_radius(fixed);
  if (point_distance(origin, fixed) > reach + distance) return {};
  if (away < point_distance(origin, turning) - distance) return {};
  if (window.lower == window.upper) {
    if (outline_distance(fixed, turned(turning, window.lower)) > distance) return {};
    return {window};
  }
  // The distance equals `distance` only where a corner of one outline touches a cap or a flank of the other. Between
  // two neighbouring contacts the answer cannot change, so one test in the middle decides.
  Contacts contacts(distance, reach + away + distance);
  contacts.add_flanks(fixed, turning, 1.0);
  contacts.add_caps(fixed, turning);
  contacts.add_flanks(turning, fixed, -1.0);

  const std::span<const double> cuts = contacts.within_turn_above(window.lower);
  std::vector<Interval> one_turn;
  for (std::size_t i = 0; i + 1 < cuts.size() && cuts[i] <= window.upper; ++i) {
    const double middle = 0.5 * (cuts[i] + cuts[i + 1]);
    if (outline_distance(fixed, turned(turning, middle)) <= distance) append(one_turn, {cuts[i], cuts[i + 1]});
  }
  return unrolled(one_turn, window);
}

std::vector<Interval> colliding_angles(const Segment& fixed, const Segment& turning, double distance, Interval window) {
  return colliding_angles(outline_of(fixed), outline_of(turning), distance, window);
}

}  // namespace dualarm
