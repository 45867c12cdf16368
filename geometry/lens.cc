#include "geometry/lens.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "geometry/plane.h"

namespace dualarm {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Part of the size of a scene by which a contact may lie beyond the end of its flank or cap, or another corner nearer,
/// and still count: more than rounding. One too many costs a test, one too few the truth.
constexpr double kBeyondEnd = 1e-9;

/// Where a corner of one figure lies at the distance from the other, and no other corner of it nearer along the normal:
/// as both are convex, that line separates them, and their distance is the distance itself.
struct Contact {
  double angle;  ///< rad, of the turning figure
  double rate;   ///< m/rad, of the figures' distance
};

/// The angles in a window of at most one turn by which a figure has to be turned about the origin so that it comes to
/// lie at a distance from the other one: each a contact of a corner with a flank or with the cap around a corner.
class Contacts {
 public:
  Contacts(double distance, double size, Interval window)
      : distance_(distance), beyond_(kBeyondEnd * size), has_sides_(distance > beyond_), window_(window) {}

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
        const Turn turn = {corners, k, radius[k], sense};
        add_flank(line, off + distance_, 1.0, turn);
        if (figure.outline.count == 2 && distance_ > 0.0) add_flank(line, off - distance_, -1.0, turn);
      }
    }
  }

  /// Of corners of what turns with the caps around the corners of an outline, which are `away` from the origin.
  void add_caps(const Outline& outline, const std::array<double, 4>& away, const Spinner& turning) {
    for (int k = 0; k < turning.figure.outline.count; ++k) {
      if (turning.radius[k] == 0.0) continue;
      const Turn turn = {turning.figure.outline, k, turning.radius[k], 1.0};
      for (int i = 0; i < outline.count; ++i) add_cap(outline, i, away[i], turn);
    }
  }

  /// All of them, ascending.
  std::span<const Contact> all() {
    std::sort(contacts_.begin(), contacts_.begin() + count_,
              [](const Contact& a, const Contact& b) { return a.angle < b.angle; });
    return {contacts_.data(), static_cast<std::size_t>(count_)};
  }

  /// Whether each is one beyond rounding, and the distance passes its value there.
  bool are_sure() const { return are_sure_; }

 private:
  /// What is beside an edge: where it lies along its direction.
  struct Line {
    Eigen::Vector2d along;
    Eigen::Vector2d outwards;  ///< to its right, which is the outside
    Interval extent;           ///< m, along
  };

  struct Turn {
    const Outline& outline;
    int index;
    double radius;
    double sense;

    const Eigen::Vector2d& corner() const { return outline.corners[index]; }
  };

  /// From where the corner is to a place as far from the origin, beside which the other figure lies against the normal.
  void add(const Eigen::Vector2d& place, const Eigen::Vector2d& normal, bool is_sure, const Turn& turn) {
    const double along = turn.corner().dot(place);
    const double across = cross(turn.corner(), place);
    const double per_square = 1.0 / (turn.radius * turn.radius);
    const Heading heading = {per_square * along, per_square * across};
    for (int i = 0; has_sides_ && i < turn.outline.count; ++i) {
      if (i == turn.index) continue;
      const double ahead = normal.dot(heading.turn(turn.outline.corners[i] - turn.corner()));
      if (ahead < -beyond_) return;
      is_sure = is_sure && ahead > beyond_;
    }
    double angle = turn.sense * std::atan2(across, along);
    if (angle < window_.lower || angle >= window_.lower + kTurn) {
      angle -= kTurn * std::floor((angle - window_.lower) / kTurn);
    }
    if (!window_.contains(angle)) return;
    const double rate = turn.sense * normal.dot(turned_left(place));
    are_sure_ = are_sure_ && has_sides_ && is_sure && std::abs(rate) > beyond_;
    contacts_[count_++] = {angle, rate};
  }

  /// The line `off` the origin along a flank meets the circle of the corner twice.
  void add_flank(const Line& line, double off, double side, const Turn& turn) {
    const double square = (turn.radius - off) * (turn.radius + off);
    if (!(square >= 0.0)) return;
    const double chord = std::sqrt(square);
    for (const double share : {-chord, chord}) {
      if (!line.extent.contains(share)) continue;
      const bool is_inside = share - line.extent.lower > 2.0 * beyond_ && line.extent.upper - share > 2.0 * beyond_;
      add(off * line.outwards + share * line.along, side * line.outwards, is_inside, turn);
    }
  }

  /// The circle around a corner of the outline meets that of the turned corner twice.
  void add_cap(const Outline& outline, int index, double away, const Turn& turn) {
    if (away == 0.0 || std::abs(away - turn.radius) > distance_ + beyond_) return;
    const double cosine =
        (turn.radius * turn.radius + away * away - distance_ * distance_) / (2.0 * turn.radius * away);
    if (!(std::abs(cosine) <= 1.0)) return;
    const Eigen::Vector2d towards = outline.corners[index] / away;
    const Eigen::Vector2d across = turned_left(towards);
    const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
    for (const double side : {-sine, sine}) {
      const Eigen::Vector2d place = turn.radius * (cosine * towards + side * across);
      const double ahead = most_ahead(outline, index, place);
      if (ahead > beyond_) continue;
      add(place, (place - outline.corners[index]) / distance_, ahead < -beyond_, turn);
    }
  }

  /// How far (m) a place lies from a corner along the edges that begin there: nowhere ahead, the corner is what of the
  /// outline is nearest to it.
  static double most_ahead(const Outline& outline, int index, const Eigen::Vector2d& place) {
    const Eigen::Vector2d& corner = outline.corners[index];
    double most = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < outline.count; ++i) {
      if (i == index || (outline.count == 4 && i == (index + 2) % 4)) continue;
      most = std::max(most, (place - corner).dot((outline.corners[i] - corner).normalized()));
    }
    return most;
  }

  /// Four corners against four flanks or caps, and the other way round for flanks, two angles each.
  static constexpr int kMost = 2 * (3 * 4 * 4);

  double distance_;
  double beyond_;
  bool has_sides_;  ///< there are distances enough to tell on which side of a flank a contact is
  Interval window_;
  std::array<Contact, kMost> contacts_;
  int count_ = 0;
  bool are_sure_ = true;
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

/// Between contacts at which the distance shrinks and grows in turn; false if it does not, or there is none to tell.
bool add_between(std::span<const Contact> contacts, Interval window, IntervalList& found) {
  if (contacts.empty()) return false;
  double from = window.lower;
  bool is_near = contacts.front().rate > 0.0;
  for (const Contact& contact : contacts) {
    if (is_near != (contact.rate > 0.0)) return false;
    if (is_near) append(found, {from, contact.angle});
    from = contact.angle;
    is_near = !is_near;
  }
  if (is_near) append(found, {from, window.upper});
  return true;
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
  // two neighbouring contacts the answer cannot change.
  const Interval first_turn = {window.lower, std::min(window.upper, window.lower + kTurn)};
  Contacts contacts(distance, turning.farthest + farthest + distance, first_turn);
  contacts.add_flanks(fixed, turning.figure.outline, turning.radius, 1.0);
  contacts.add_caps(fixed.outline, away, turning);
  contacts.add_flanks(turning.figure, fixed.outline, away, -1.0);

  const std::span<const Contact> cuts = contacts.all();
  if (!contacts.are_sure() || !add_between(cuts, first_turn, found)) {
    found.clear();
    double from = first_turn.lower;
    const auto add_up_to = [&](double to) {
      if (collides_at(0.5 * (from + to))) append(found, {from, to});
      from = to;
    };
    for (const Contact& cut : cuts) add_up_to(cut.angle);
    add_up_to(first_turn.upper);
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
