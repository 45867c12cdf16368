#include "core/coordination/projection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/coordination/least_value.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Part of the duration that sets the resolution to which the projection is proven before its ends are polished.
constexpr double kResolution = 1e-4;
/// Part of the duration that sets the resolution below which a cell is not halved any more. Within so short a time no
/// body moves farther than a small part of the planner's margin.
constexpr double kShortestCell = 1e-9;
/// Part of the duration to which ends are polished: a digit above rounding.
constexpr double kPolish = 1e-14;
/// Cells of each leg of the arm at the start of the subdivision.
constexpr int kFirstCells = 16;

/// A piece of a leg of the arm, with the times at its ends.
struct Cell {
  const Leg* leg = nullptr;
  double from = 0.0;
  double to = 0.0;
  double from_time = 0.0;
  double to_time = 0.0;

  Interval positions() const { return {std::min(from, to), std::max(from, to)}; }
  double middle() const { return 0.5 * (from + to); }
};

/// When the arm is somewhere, and the times of the other clock that this forbids.
struct TimedSlice {
  double time = 0.0;
  std::vector<Interval> others;
};

class Projection {
 public:
  Projection(const Meetings& meetings, const Profile& arm, const ProjectionRules& rules, const Budget& budget)
      : meetings_(meetings),
        budget_(budget),
        arm_(arm),
        rules_(rules),
        longest_(rules.longest),
        resolution_(kResolution * longest_) {}

  std::optional<IntervalSet> run() {
    stand_still();
    if (!subdivide()) return std::nullopt;
    IntervalSet differences = polished();
    if (budget_.exhausted()) return std::nullopt;  // slices end early then
    return differences;
  }

 private:
  /// The arm before its start forbids all differences up to a value, after its arrival all from a value.
  void stand_still() {
    for (const Interval& times : meetings_.times_at(arm_.start())) found_.push_back({-kInfinity, -times.lower});
    for (const Interval& times : meetings_.times_at(arm_.goal())) {
      const double arrival = arm_.duration() - times.upper;
      found_.push_back({arrival, rules_.stands_at_goal ? kInfinity : arm_.duration() - times.lower});
    }
  }

  std::vector<Cell> first_cells() const {
    std::vector<Cell> cells;
    for (const Leg& leg : arm_.legs()) {
      double from = leg.start;
      double from_time = leg.start_time;
      for (int i = 1; i <= kFirstCells; ++i) {
        const double to = i == kFirstCells ? leg.goal : leg.start + (leg.goal - leg.start) * i / kFirstCells;
        const double to_time = arm_.time_at(leg, to);
        cells.push_back({&leg, from, to, from_time, to_time});
        from = to;
        from_time = to_time;
      }
    }
    return cells;
  }

  /// Halves the cells of the arm's legs until each forbids nothing that exact slices do not forbid, to the resolution.
  /// Breadth first, so that wide slices spare the narrow cells. False if the budget ran out.
  bool subdivide() {
    std::vector<Cell> cells = first_cells();
    while (!cells.empty()) {
      const IntervalSet known = joined();
      found_ = known.intervals();
      std::vector<Cell> halves;
      for (const Cell& cell : cells) {
        if (budget_.exhausted()) return false;
        const std::vector<Interval> outer = differences_of(cell);
        if (all_covered(outer, known, 0.0)) continue;
        if (all_covered(outer, known, resolution_) || is_shortest(cell)) {
          leaves_.push_back(cell);
        } else {
          split(cell, halves);
        }
      }
      cells = std::move(halves);
    }
    return true;
  }

  /// Near a turning point a short time is a shorter way than positions can tell apart.
  bool is_shortest(const Cell& cell) const {
    return cell.to_time - cell.from_time < kShortestCell * longest_ || cell.middle() == cell.from ||
           cell.middle() == cell.to;
  }

  void split(const Cell& cell, std::vector<Cell>& halves) {
    const double middle = cell.middle();
    const double middle_time = arm_.time_at(*cell.leg, middle);
    for (const Interval& times : meetings_.times_at(middle)) {
      found_.push_back({middle_time - times.upper, middle_time - times.lower});
    }
    halves.push_back({cell.leg, cell.from, middle, cell.from_time, middle_time});
    halves.push_back({cell.leg, middle, cell.to, middle_time, cell.to_time});
  }

  static bool all_covered(const std::vector<Interval>& intervals, const IntervalSet& set, double tolerance) {
    return std::all_of(intervals.begin(), intervals.end(), [&](const Interval& i) { return set.covers(i, tolerance); });
  }

  /// A superset of the differences that a cell forbids.
  std::vector<Interval> differences_of(const Cell& cell) const {
    std::vector<Interval> differences = meetings_.times_over(cell.positions());
    for (Interval& times : differences) times = {cell.from_time - times.upper, cell.to_time - times.lower};
    return differences;
  }

  /// The set with its gaps closed that leaves on both sides, forbidden to the resolution, may fill.
  IntervalSet joined() const { return unite_across(found_, 2.0 * resolution_); }

  /// Each finite end moved outwards to the extremum of the exact slices near it.
  IntervalSet polished() {
    std::sort(leaves_.begin(), leaves_.end(), [](const Cell& a, const Cell& b) { return a.from_time < b.from_time; });
    for (const Cell& leaf : leaves_) middles_.push_back(slice_at(*leaf.leg, leaf.middle()));
    std::vector<Interval> result = joined().intervals();
    for (Interval& interval : result) {
      const double lower = polished_end(interval, 1.0);
      const double upper = -polished_end({-interval.upper, -interval.lower}, -1.0);
      interval = {lower, upper};
    }
    return IntervalSet(std::move(result));
  }

  /// The lower end of `interval`, one of sign * (forbidden differences): the least of the local minima in the leaves. A
  /// turning point ends its leg's leaves: on both sides of it the same positions come at other times.
  double polished_end(Interval interval, double sign) const {
    if (!std::isfinite(interval.lower)) return interval.lower;
    std::vector<double> lowest;
    lowest.reserve(middles_.size());
    for (const TimedSlice& slice : middles_) lowest.push_back(end_of_slice(slice, interval, sign));
    double best = interval.lower;
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
      const bool has_left = i > 0 && follows(leaves_[i - 1], leaves_[i]);
      const bool has_right = i + 1 < leaves_.size() && follows(leaves_[i], leaves_[i + 1]);
      const bool is_minimum = (!has_left || lowest[i] <= lowest[i - 1]) && (!has_right || lowest[i] <= lowest[i + 1]);
      if (!is_minimum || lowest[i] > interval.lower + 2.0 * resolution_) continue;
      const double left = has_left ? leaves_[i - 1].middle() : leaves_[i].from;
      const double right = has_right ? leaves_[i + 1].middle() : leaves_[i].to;
      const Leg& leg = *leaves_[i].leg;
      const auto lowest_at = [&](double position) { return end_of_slice(slice_at(leg, position), interval, sign); };
      const auto value_at = [&](bool is_known, std::size_t leaf, double position) {
        return Looked{position, is_known ? lowest[leaf] : lowest_at(position)};
      };
      best = std::min(best, least_value(lowest_at,
                                        {value_at(has_left, i - 1, left),
                                         {leaves_[i].middle(), lowest[i]},
                                         value_at(has_right, i + 1, right)},
                                        kPolish * longest_));
    }
    return best;
  }

  static bool follows(const Cell& before, const Cell& after) {
    return before.leg == after.leg && before.to == after.from;
  }

  TimedSlice slice_at(const Leg& leg, double position) const {
    return {arm_.time_at(leg, position), meetings_.times_at(position)};
  }

  /// The least of sign * (differences that a slice forbids) that belongs to `interval`; infinite if there is none, as
  /// beyond the tip of the set.
  double end_of_slice(const TimedSlice& slice, Interval interval, double sign) const {
    double lowest = kInfinity;
    for (const Interval& times : slice.others) {
      const double end = sign > 0.0 ? slice.time - times.upper : times.lower - slice.time;
      if (end >= interval.lower - 2.0 * resolution_ && end <= interval.upper) lowest = std::min(lowest, end);
    }
    return lowest;
  }

  const Meetings& meetings_;
  const Budget& budget_;
  const Profile& arm_;
  ProjectionRules rules_;
  double longest_;     ///< s
  double resolution_;  ///< s
  std::vector<Interval> found_;
  std::vector<Cell> leaves_;
  std::vector<TimedSlice> middles_;  ///< of the leaves
};

}  // namespace

std::optional<IntervalSet> project(const Meetings& meetings, const Profile& arm, const ProjectionRules& rules,
                                   const Budget& budget) {
  return Projection(meetings, arm, rules, budget).run();
}

}  // namespace dualarm
