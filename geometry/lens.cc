#include "geometry/lens.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dualarm {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double angle_of(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }

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

/// The angles by which a corner has to be turned about the origin to come to lie at a distance from an outline, each a
/// contact with a flank or with the cap around a corner.
class Contacts {
 public:
  Contacts(double distance, double size) : distance_(distance), beyond_(kBeyondEnd * size) {}

  /// `sense` -1 where it is the outline that turns.
  void add(const Outline& outline, const Eigen::Vector2d& corner, double sense, bool with_caps) {
    const double radius = corner.norm();
    if (radius == 0.0) return;
    const Turn turn = {radius, angle_of(corner), sense};
    for (int i = 0; i < edge_count(outline); ++i) {
      add_flank(edge(outline, i), distance_, turn);
      if (outline.count == 2) add_flank(edge(outline, i), -distance_, turn);
    }
    for (int i = 0; with_caps && i < outline.count; ++i) add_cap(outline, i, turn);
  }

  /// All of them within one turn above `from`, ascending, with the turn's two ends.
  const std::vector<double>& within_turn_above(double from) {
    for (double& angle : angles_) angle = from + std::fmod(std::fmod(angle - from, kTurn) + kTurn, kTurn);
    angles_.push_back(from);
    angles_.push_back(from + kTurn);
    std::sort(angles_.begin(), angles_.end());
    return angles_;
  }

 private:
  struct Turn {
    double radius;
    double bearing;
    double sense;
  };

  void add(const Eigen::Vector2d& place, const Turn& turn) {
    angles_.push_back(turn.sense * (angle_of(place) - turn.bearing));
  }

  /// The line beside an edge, on its outer (right) side, meets the circle of the corner twice.
  void add_flank(const Segment& flank, double distance, const Turn& turn) {
    const Eigen::Vector2d along = (flank.end - flank.start).normalized();
    const Eigen::Vector2d outwards(along.y(), -along.x());
    const double off = outwards.dot(flank.start) + distance;
    if (!(std::abs(off) <= turn.radius)) return;
    const double chord = std::sqrt((turn.radius - off) * (turn.radius + off));
    const Interval extent = {along.dot(flank.start) - beyond_, along.dot(flank.end) + beyond_};
    for (const double share : {-chord, chord}) {
      if (extent.contains(share)) add(off * outwards + share * along, turn);
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

  double distance_;
  double beyond_;
  std::vector<double> angles_;
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
  for (int i = 0; i < turning.count; ++i) contacts.add(fixed, turning.corners[i], 1.0, true);
  for (int i = 0; i < fixed.count; ++i) contacts.add(turning, fixed.corners[i], -1.0, false);

  const std::vector<double>& cuts = contacts.within_turn_above(window.lower);
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
