#include "geometry/lens.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace dualarm {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Part of the size of a scene by which a contact may lie beyond the end of its flank or cap and still count: more than
/// rounding. One too many costs a test, one too few the truth.
constexpr double kBeyondEnd = 1e-9;

/// The angles in a window of at most one turn by which a figure has to be turned about the origin so that a corner of
/// one comes to lie at a distance from the other: each a contact with a flank or with the cap around a corner.
class Contacts {
 public:
  Contacts(double distance, double size, Interval window)
      : distance_(distance), beyond_(kBeyondEnd * size), window_(window) {}

  /// Of corners, with their distances from the origin, with the flanks of a figure. `sense` -1 where it is the figure
  /// that turns.
  void add_flanks(const Figure& figure, const Outline& corners, const std::array<double, 4>& radius, double sense) {
    for (int i = 0; i < figure.edge_count(); ++i) {
      const Eigen::Vector2d& along = figure.along[i];
      const Eigen::Vector2d outwards(along.y(), -along.x());
      const double off = outwards.dot(figure.outline.corners[i]);
      const double begin = along.dot(figure.outline.corners[i]);
      const Line line = {along, outwards, {begin - beyond_, begin + figure.length[i] + beyond_}};
      for (int k = 0; k < corners.count; ++k) {
        if (radius[k] == 0.0) continue;
        const Turn turn = {corners.corners[k], radius[k], sense};
        add_flank(line, off + distance_, turn);
        if (figure.outline.count == 2 && distance_ > 0.0) add_flank(line, off - distance_, turn);
      }
    }
  }

  /// Of corners of what turns with the caps around the corners of an outline, which are `away` from the origin.
  void add_caps(const Outline& outline, const std::array<double, 4>& away, const Spinner& turning) {
    for (int k = 0; k < turning.figure.outline.count; ++k) {
      if (turning.radius[k] == 0.0) continue;
      const Turn turn = {turning.figure.outline.corners[k], turning.radius[k], 1.0};
      for (int i = 0; i < outline.count; ++i) add_cap(outline, i, away[i], turn);
    }
  }

  /// All of them, ascending, with the window's two ends.
  std::span<const double> cuts() {
    angles_[count_++] = window_.lower;
    angles_[count_++] = window_.upper;
    std::sort(angles_.begin(), angles_.begin() + count_);
    return {angles_.data(), static_cast<std::size_t>(count_)};
  }

 private:
  /// What is beside an edge: where it lies along its direction.
  struct Line {
    Eigen::Vector2d along;
    Eigen::Vector2d outwards;  ///< to its right, which is the outside
    Interval extent;           ///< m, along
  };

  struct Turn {
    Eigen::Vector2d corner;
    double radius;
    double sense;
  };

  /// From where the corner is to a place as far from the origin.
  void add(const Eigen::Vector2d& place, const Turn& turn) {
    double angle = turn.sense * std::atan2(cross(turn.corner, place), turn.corner.dot(place));
    if (angle < window_.lower || angle >= window_.lower + kTurn) {
      angle -= kTurn * std::floor((angle - window_.lower) / kTurn);
    }
    if (window_.contains(angle)) angles_[count_++] = angle;
  }

  /// The line `off` the origin along a flank meets the circle of the corner twice.
  void add_flank(const Line& line, double off, const Turn& turn) {
    const double square = (turn.radius - off) * (turn.radius + off);
    if (!(square >= 0.0)) return;
    const double chord = std::sqrt(square);
    for (const double share : {-chord, chord}) {
      if (line.extent.contains(share)) add(off * line.outwards + share * line.along, turn);
    }
  }

  /// The circle around a corner of the outline meets that of the turned corner twice.
  void add_cap(const Outline& outline, int index, double away, const Turn& turn) {
    if (away == 0.0 || std::abs(away - turn.radius) > distance_ + beyond_) return;
    const double cosine =
        (turn.radius * turn.radius + away * away - distance_ * distance_) / (2.0 * turn.radius * away);
    if (!(std::abs(cosine) <= 1.0)) return;
    const Eigen::Vector2d towards = outline.corners[index] / away;
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
      const Eigen::Vector2d towards = outline.corners[i] - corner;
      const double ahead = (place - corner).dot(towards);
      if (ahead > 0.0 && ahead > beyond_ * towards.norm()) return false;
    }
    return true;
  }

  /// Four corners against four flanks or caps, and the other way round for flanks, two angles each; and two ends.
  static constexpr int kMost = 2 * (3 * 4 * 4) + 2;

  double distance_;
  double beyond_;
  Interval window_;
  std::array<double, kMost> angles_;
  int count_ = 0;
};

/// Pieces closer than this (rad) are one: the same cut, computed twice.
constexpr double kSeam = 1e-13;

void append(IntervalList& intervals, Interval next) {
  if (!intervals.empty() && next.lower <= intervals.back().upper + kSeam) {
    intervals.back().upper = std::max(intervals.back().upper, next.upper);
  } else {
    intervals.push_back(next);
  }
}

/// The intervals of the first turn of `window`, repeated for every turn that it meets, cut to it.
IntervalList unrolled(const IntervalList& one_turn, Interval window) {
  IntervalList result;
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

Spinner spinner_of(const Outline& outline) {
  Spinner spinner;
  spinner.figure = figure_of(outline);
  for (int i = 0; i < outline.count; ++i) {
    spinner.radius[i] = outline.corners[i].norm();
    spinner.farthest = std::max(spinner.farthest, spinner.radius[i]);
  }
  spinner.nearest = point_distance(Eigen::Vector2d::Zero(), spinner.figure);
  return spinner;
}

IntervalList colliding_angles(const Figure& fixed, const Spinner& turning, double distance, Interval window) {
  std::array<double, 4> away;
  double farthest = 0.0;
  for (int i = 0; i < fixed.outline.count; ++i) {
    away[i] = fixed.outline.corners[i].norm();
    farthest = std::max(farthest, away[i]);
  }
  IntervalList found;
  if (farthest < turning.nearest - distance) return found;
  if (point_distance(Eigen::Vector2d::Zero(), fixed) > turning.farthest + distance) return found;
  const auto collides_at = [&](double angle) {
    return are_within(fixed, moved(turning.figure, heading_of(angle), Eigen::Vector2d::Zero()), distance);
  };
  if (window.lower == window.upper) {
    if (collides_at(window.lower)) found.push_back(window);
    return found;
  }
  // The distance equals `distance` only where a corner of one outline touches a cap or a flank of the other. Between
  // two neighbouring contacts the answer cannot change, so one test in the middle decides.
  const Interval first_turn = {window.lower, std::min(window.upper, window.lower + kTurn)};
  Contacts contacts(distance, turning.farthest + farthest + distance, first_turn);
  contacts.add_flanks(fixed, turning.figure.outline, turning.radius, 1.0);
  contacts.add_caps(fixed.outline, away, turning);
  contacts.add_flanks(turning.figure, fixed.outline, away, -1.0);

  const std::span<const double> cuts = contacts.cuts();
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (collides_at(0.5 * (cuts[i] + cuts[i + 1]))) append(found, {cuts[i], cuts[i + 1]});
  }
  if (first_turn.upper < window.upper) {
    const IntervalList all = unrolled(found, window);
    found.assign(all.begin(), all.end());
  }
  return found;
}

IntervalList colliding_angles(const Outline& fixed, const Outline& turning, double distance, Interval window) {
  return colliding_angles(figure_of(fixed), spinner_of(turning), distance, window);
}

IntervalList colliding_angles(const Segment& fixed, const Segment& turning, double distance, Interval window) {
  return colliding_angles(outline_of(fixed), outline_of(turning), distance, window);
}

}  // namespace dualarm
