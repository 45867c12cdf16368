#include "core/coordination/diagram.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <optional>

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Part of the longer duration to which the projection is proven before its ends are polished.
constexpr double kResolution = 1e-5;
/// Cells of arm 1's path at the start of the subdivision.
constexpr int kFirstCells = 16;

/// A piece of arm 1's path, with the times at its ends.
struct Cell {
  double from = 0.0;
  double to = 0.0;
  double from_time = 0.0;
  double to_time = 0.0;

  Interval positions() const { return {std::min(from, to), std::max(from, to)}; }
};

class Projection {
 public:
  Projection(const ForbiddenSet& forbidden, const Profile& first, const Profile& second)
      : forbidden_(forbidden),
        first_(first),
        second_(second),
        window_{std::min(second.start(), second.goal()), std::max(second.start(), second.goal())},
        resolution_(kResolution * std::max(first.duration(), second.duration())) {}

  IntervalSet run() {
    stand_still();
    if (first_.direction() != 0) subdivide();
    return polished();
  }

 private:
  /// Arm 1 before its start forbids all delays up to a value, after its arrival all from a value.
  void stand_still() {
    for (const Interval& times : times_of_second(forbidden_.slice(first_.start(), window_))) {
      found_.push_back({-kInfinity, -times.lower});
    }
    for (const Interval& times : times_of_second(forbidden_.slice(first_.goal(), window_))) {
      found_.push_back({first_.duration() - times.upper, kInfinity});
    }
  }

  /// Halves the cells of arm 1's path until each forbids nothing beyond what exact slices forbid, or is too short to
  /// matter. Breadth first, so that wide slices spare the narrow cells.
  void subdivide() {
    std::vector<Cell> cells;
    double from = first_.start();
    double from_time = 0.0;
    for (int i = 1; i <= kFirstCells; ++i) {
      const double to = first_.start() + (first_.goal() - first_.start()) * i / kFirstCells;
      const double to_time = first_.time_at(to);
      cells.push_back({from, to, from_time, to_time});
      from = to;
      from_time = to_time;
    }
    while (!cells.empty()) {
      const IntervalSet known = joined(found_);
      found_ = known.intervals();
      std::vector<Cell> halves;
      for (const Cell& cell : cells) split(cell, known, halves);
      cells = std::move(halves);
    }
  }

  void split(const Cell& cell, const IntervalSet& known, std::vector<Cell>& halves) {
    const std::vector<Interval> outer = delays_of(cell);
    if (std::all_of(outer.begin(), outer.end(), [&](const Interval& delays) { return known.covers(delays); })) return;
    const double middle = 0.5 * (cell.from + cell.to);
    if (cell.to_time - cell.from_time < resolution_ || middle == cell.from || middle == cell.to) {
      leaves_.push_back(cell);
      found_.insert(found_.end(), outer.begin(), outer.end());
      return;
    }
    const double middle_time = first_.time_at(middle);
    for (const Interval& times : times_of_second(forbidden_.slice(middle, window_))) {
      found_.push_back({middle_time - times.upper, middle_time - times.lower});
    }
    halves.push_back({cell.from, middle, cell.from_time, middle_time});
    halves.push_back({middle, cell.to, middle_time, cell.to_time});
  }

  /// A superset of the delays that a cell forbids.
  std::vector<Interval> delays_of(const Cell& cell) const {
    std::vector<Interval> delays;
    for (const Interval& times : times_of_second(forbidden_.slice_over(cell.positions(), window_))) {
      delays.push_back({cell.from_time - times.upper, cell.to_time - times.lower});
    }
    return delays;
  }

  std::vector<Interval> times_of_second(const IntervalSet& positions) const {
    std::vector<Interval> times;
    for (const Interval& piece : positions.intervals()) {
      const IntervalSet of_piece = second_.times_in(piece);
      times.insert(times.end(), of_piece.intervals().begin(), of_piece.intervals().end());
    }
    return times;
  }

  /// The set with gaps below the resolution closed.
  IntervalSet joined(std::vector<Interval> intervals) const {
    for (Interval& interval : intervals) interval.upper += resolution_;
    IntervalSet widened(std::move(intervals));
    std::vector<Interval> result = widened.intervals();
    for (Interval& interval : result) interval.upper -= resolution_;
    return IntervalSet(std::move(result));
  }

  /// Each finite end replaced by the extremum of the exact slices near it.
  IntervalSet polished() const {
    std::vector<Interval> result = joined(found_).intervals();
    for (Interval& interval : result) {
      interval.upper = -polished_lower_end({-interval.upper, -interval.lower}, -1.0);
      interval.lower = polished_lower_end(interval, 1.0);
    }
    return IntervalSet(std::move(result));
  }

  /// Lower end of sign * (forbidden delays) of one interval, refined within the leaves that reach it.
  double polished_lower_end(Interval interval, double sign) const {
    if (!std::isfinite(interval.lower)) return interval.lower;
    const auto lowest_at = [&](double position) {
      const double time = first_.time_at(position);
      double lowest = kInfinity;
      for (const Interval& times : times_of_second(forbidden_.slice(position, window_))) {
        const double end = sign > 0.0 ? time - times.upper : times.lower - time;
        if (end >= interval.lower - resolution_ && end <= interval.upper) lowest = std::min(lowest, end);
      }
      return lowest;
    };
    double best = standing_end(interval, sign);
    for (const Interval& bracket : brackets_reaching(interval.lower, sign)) {
      // Brent's method needs finite values; beyond the tip of the set the slice is empty.
      const double outside = interval.lower + 1e3 * resolution_;
      const auto bounded = [&](double position) { return std::min(lowest_at(position), outside); };
      const auto [position, lowest] = boost::math::tools::brent_find_minima(bounded, bracket.lower, bracket.upper, 52);
      best = std::min({best, lowest, lowest_at(bracket.lower), lowest_at(bracket.upper)});
    }
    return std::isfinite(best) ? std::max(best, interval.lower) : interval.lower;
  }

  /// The end that arm 1 standing at its start or goal contributes, if it is the one that counts.
  double standing_end(Interval interval, double sign) const {
    double best = kInfinity;
    for (const bool at_goal : {false, true}) {
      const double time = at_goal ? first_.duration() : 0.0;
      for (const Interval& times :
           times_of_second(forbidden_.slice(at_goal ? first_.goal() : first_.start(), window_))) {
        const double end = sign > 0.0 ? time - times.upper : times.lower - time;
        if (end >= interval.lower - resolution_ && end <= interval.upper) best = std::min(best, end);
      }
    }
    return best;
  }

  /// Runs of neighbouring leaves that may contain the lower end of sign * delays.
  std::vector<Interval> brackets_reaching(double lower_end, double sign) const {
    std::vector<Interval> near;
    for (const Cell& leaf : leaves_) {
      for (const Interval& delays : delays_of(leaf)) {
        const double end = sign > 0.0 ? delays.lower : -delays.upper;
        if (std::abs(end - lower_end) <= 4.0 * resolution_) near.push_back(leaf.positions());
      }
    }
    return IntervalSet(std::move(near)).intervals();
  }

  const ForbiddenSet& forbidden_;
  const Profile& first_;
  const Profile& second_;
  Interval window_;
  double resolution_;
  std::vector<Interval> found_;
  std::vector<Cell> leaves_;
};

}  // namespace

IntervalSet forbidden_delays(const ForbiddenSet& forbidden, const Profile& first, const Profile& second) {
  return Projection(forbidden, first, second).run();
}

}  // namespace dualarm
