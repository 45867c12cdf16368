#include "geometry/lens.h"

#include <algorithm>
#include <cmath>
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

Segment turned(const Segment& segment, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const auto turn = [&](const Eigen::Vector2d& p) {
    return Eigen::Vector2d(c * p.x() - s * p.y(), s * p.x() + c * p.y());
  };
  return {turn(segment.start), turn(segment.end)};
}

/// Collects centre - offset and centre + offset for cos(offset) = cosine, where that exists.
class Candidates {
 public:
  void add(double centre, double cosine) {
    if (!(std::abs(cosine) <= 1.0)) return;
    const double offset = std::acos(cosine);
    angles_.push_back(centre - offset);
    angles_.push_back(centre + offset);
  }

  /// An end of the turning segment (in polar form) at `distance` from the fixed one: on a cap, or on a flank.
  void add_end_of_turning(const Eigen::Vector2d& end, const Segment& fixed, double distance) {
    const double radius = end.norm();
    if (radius == 0.0) return;
    const double bearing = angle_of(end);
    for (const Eigen::Vector2d* cap : {&fixed.start, &fixed.end}) {
      const double cap_radius = cap->norm();
      add(angle_of(*cap) - bearing,
          (radius * radius + cap_radius * cap_radius - distance * distance) / (2.0 * radius * cap_radius));
    }
    const Eigen::Vector2d along = fixed.end - fixed.start;
    if (along.norm() == 0.0) return;
    const Eigen::Vector2d normal = Eigen::Vector2d(-along.y(), along.x()).normalized();
    for (const double side : {-distance, distance}) {
      add(angle_of(normal) - bearing, (normal.dot(fixed.start) + side) / radius);
    }
  }

  /// A flank of the turning segment at `distance` from an end of the fixed one.
  void add_flank_of_turning(const Segment& turning, const Eigen::Vector2d& end, double distance) {
    const Eigen::Vector2d along = turning.end - turning.start;
    const double end_radius = end.norm();
    if (along.norm() == 0.0 || end_radius == 0.0) return;
    const Eigen::Vector2d normal = Eigen::Vector2d(-along.y(), along.x()).normalized();
    for (const double side : {-distance, distance}) {
      add(angle_of(end) - angle_of(normal), (normal.dot(turning.start) + side) / end_radius);
    }
  }

  /// All of them within one turn above `from`, ascending, with the turn's two ends.
  std::vector<double> within_turn_above(double from) {
    for (double& angle : angles_) angle = from + std::fmod(std::fmod(angle - from, kTurn) + kTurn, kTurn);
    angles_.push_back(from);
    angles_.push_back(from + kTurn);
    std::sort(angles_.begin(), angles_.end());
    return angles_;
  }

 private:
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

double segment_distance(const Segment& first, const Segment& second) {
  if (cross_each_other(first, second)) return 0.0;
  return std::min({point_distance(first.start, second), point_distance(first.end, second),
                   point_distance(second.start, first), point_distance(second.end, first)});
}

std::vector<Interval> colliding_angles(const Segment& fixed, const Segment& turning, double distance, Interval window) {
  const Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  const double reach = std::max(turning.start.norm(), turning.end.norm());
  if (point_distance(origin, fixed) > reach + distance) return {};
  if (std::max(fixed.start.norm(), fixed.end.norm()) < point_distance(origin, turning) - distance) return {};
  // The distance equals `distance` only where an end of one segment touches a cap or a flank of the other. Between two
  // neighbouring candidates the answer cannot change, so one test in the middle decides.
  Candidates candidates;
  candidates.add_end_of_turning(turning.start, fixed, distance);
  candidates.add_end_of_turning(turning.end, fixed, distance);
  candidates.add_flank_of_turning(turning, fixed.start, distance);
  candidates.add_flank_of_turning(turning, fixed.end, distance);

  const std::vector<double> cuts = candidates.within_turn_above(window.lower);
  std::vector<Interval> one_turn;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double middle = 0.5 * (cuts[i] + cuts[i + 1]);
    if (segment_distance(fixed, turned(turning, middle)) <= distance) append(one_turn, {cuts[i], cuts[i + 1]});
  }
  return unrolled(one_turn, window);
}

}  // namespace dualarm
