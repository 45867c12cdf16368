#include "core/coordination/projection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
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
constexpr int kFirstCells = 8;
/// Intervals up to which the ends of what the first slices show are worth polishing.
constexpr std::size_t kFew = 3;

/// A piece of a leg of the arm, with the times at its ends.
struct Cell {
  const Leg* leg = nullptr;
  double from = 0.0;
  double to = 0.0;
  double from_time = 0.0;
  double to_time = 0.0;

  Interval positions() const { return {std::min(from, to), std::max(from, to)}; }
  Interval times() const { return {from_time, to_time}; }
  double middle() const { return 0.5 * (from + to); }
};

/// When the arm is somewhere, and the times of the other clock that this forbids.
struct TimedSlice {
  const Leg* leg = nullptr;
  double position = 0.0;
  double time = 0.0;
  IntervalList others;
};

/// Differences of which it is asked whether they are free, and on which sides forbidden ones are next to them.
struct Doubt {
  Interval differences;
  bool is_below_known = false;
  bool is_above_known = false;

  double likely() const {
    if (is_below_known || !std::isfinite(differences.lower)) return differences.upper;
    if (is_above_known || !std::isfinite(differences.upper)) return differences.lower;
    return 0.5 * (differences.lower + differences.upper);
  }
};

using Doubts = boost::container::small_vector<Doubt, 8>;

/// What of `differences` is not known to be forbidden, give or take a tolerance; what is next to something known on
/// both sides in two halves.
Doubts doubts(Interval differences, const IntervalSet& known, double tolerance) {
  Doubts result;
  double from = differences.lower;
  bool is_above_known = false;
  const auto add = [&](double to, bool is_below_known) {
    if (!(from < to)) return;
    if (is_below_known && is_above_known) {
      const double middle = 0.5 * (from + to);
      result.push_back({{from, middle}, false, true});
      result.push_back({{middle, to}, true, false});
    } else {
      result.push_back({{from, to}, is_below_known, is_above_known});
    }
  };
  for (const Interval& interval : known.intervals()) {
    const Interval wide = {interval.lower - tolerance, interval.upper + tolerance};
    if (wide.upper < from) continue;
    if (wide.lower > differences.upper) break;
    add(wide.lower, true);
    is_above_known = true;
    from = std::max(from, wide.upper);
  }
  add(differences.upper, false);
  return result;
}

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
    look_first();
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

  /// The first cells, about evenly spaced in time, with slices between them; and the ends of what these show, polished:
  /// most cells can forbid nothing beyond.
  void look_first() {
    std::vector<TimedSlice> slices;
    slices.reserve(kFirstCells * arm_.legs().size());
    cells_.reserve(slices.capacity());
    for (const Leg& leg : arm_.legs()) {
      double from = leg.start;
      double from_time = leg.start_time;
      for (int i = 1; i <= kFirstCells; ++i) {
        const double share = 0.5 - 0.5 * std::cos(std::numbers::pi * i / kFirstCells);
        const double to = i == kFirstCells ? leg.goal : leg.start + (leg.goal - leg.start) * share;
        slices.push_back(slice_at(leg, to));
        cells_.push_back({&leg, from, to, from_time, slices.back().time});
        from = to;
        from_time = slices.back().time;
        learn(slices.back());
      }
    }
    const IntervalSet known = joined();
    if (known.intervals().size() > kFew) return;
    for (std::size_t i = 0; i < known.intervals().size(); ++i) {
      const Interval& interval = known.intervals()[i];
      const double below = i > 0 ? known.intervals()[i - 1].upper : -kInfinity;
      const double above = i + 1 < known.intervals().size() ? known.intervals()[i + 1].lower : kInfinity;
      polish_first(slices, interval, below, 1.0);
      polish_first(slices, {-interval.upper, -interval.lower}, -above, -1.0);
    }
  }

  /// Polishes the lower end of `interval`, one of sign * (what the first slices forbid), down to `limit` at most.
  void polish_first(const std::vector<TimedSlice>& slices, Interval interval, double limit, double sign) {
    if (!std::isfinite(interval.lower)) return;
    const Interval ends = {limit, interval.upper};
    const auto end_of = [&](const TimedSlice& slice) { return end_of_slice(slice, ends, sign); };
    const auto lower = [&](const TimedSlice& a, const TimedSlice& b) { return end_of(a) < end_of(b); };
    const auto at = std::min_element(slices.begin(), slices.end(), lower);
    if (at == slices.begin() || at + 1 == slices.end() || end_of(*at) > interval.lower + resolution_) return;
    const Leg& leg = *at->leg;
    if ((at - 1)->leg != &leg || (at + 1)->leg != &leg) return;
    TimedSlice lowest = *at;
    const auto looked = [&](const TimedSlice& slice) { return Looked{slice.position, end_of(slice)}; };
    const auto lowest_at = [&](double position) {
      const TimedSlice slice = slice_at(leg, position);
      if (lower(slice, lowest)) lowest = slice;
      return end_of(slice);
    };
    least_value(lowest_at, {looked(*(at - 1)), looked(*at), looked(*(at + 1))}, kPolish * longest_);
    learn(lowest);
  }

  void learn(const TimedSlice& slice) {
    for (const Interval& times : slice.others) found_.push_back({slice.time - times.upper, slice.time - times.lower});
  }

  /// Halves the cells of the arm's legs until each forbids nothing that exact slices do not forbid, to the resolution.
  /// Breadth first, so that wide slices spare the narrow cells. False if the budget ran out.
  bool subdivide() {
    std::vector<Cell> halves;
    while (!cells_.empty()) {
      const IntervalSet known = joined();
      found_ = known.intervals();
      halves.clear();
      for (const Cell& cell : cells_) {
        if (budget_.exhausted()) return false;
        const IntervalList others = meetings_.times_over(cell.positions());
        if (forbids_no_more(cell, others, known, kPolish * longest_)) continue;
        if (is_covered(cell, others, known, resolution_) || is_shortest(cell)) {
          leaves_.push_back(cell);
          continue;
        }
        const TimedSlice middle = slice_at(*cell.leg, cell.middle());
        if (shows_an_end(middle, known) && forbids_no_more(cell, others, known, resolution_)) {
          leaves_.push_back(cell);
        } else {
          split(cell, middle, halves);
        }
      }
      std::swap(cells_, halves);
    }
    return true;
  }

  /// The differences of a cell, of which a superset of the other times is given.
  static Interval differences_at(const Cell& cell, const Interval& times) {
    return {cell.from_time - times.upper, cell.to_time - times.lower};
  }

  /// Whether the superset itself lies within what is known, give or take a tolerance.
  static bool is_covered(const Cell& cell, const IntervalList& others, const IntervalSet& known, double tolerance) {
    return std::all_of(others.begin(), others.end(),
                       [&](const Interval& times) { return known.covers(differences_at(cell, times), tolerance); });
  }

  /// Whether a slice ends next to where what is known ends: then the end that a wide cell around it may have can be
  /// polished from there.
  bool shows_an_end(const TimedSlice& slice, const IntervalSet& known) const {
    const auto is_near = [&](double a, double b) { return std::abs(a - b) <= 2.0 * resolution_; };
    return std::any_of(slice.others.begin(), slice.others.end(), [&](const Interval& times) {
      const Interval shown = {slice.time - times.upper, slice.time - times.lower};
      return std::any_of(known.intervals().begin(), known.intervals().end(), [&](const Interval& interval) {
        return is_near(shown.lower, interval.lower) || is_near(shown.upper, interval.upper);
      });
    });
  }

  /// Whether a cell is proven to forbid no more than what is known, give or take a tolerance. Of a wide cell this says
  /// nothing about where in it an end may be polished.
  bool forbids_no_more(const Cell& cell, const IntervalList& others, const IntervalSet& known, double tolerance) const {
    if (is_covered(cell, others, known, tolerance)) return true;
    Patch patch = {cell.times(), {}, {}, 0.0, cell.leg, cell.middle(), arm_.time_at(*cell.leg, cell.middle())};
    return std::all_of(others.begin(), others.end(), [&](const Interval& times) {
      patch.others = times;
      const Doubts open = doubts(differences_at(cell, times), known, tolerance);
      return std::all_of(open.begin(), open.end(), [&](const Doubt& doubt) {
        patch.differences = doubt.differences;
        patch.likely_difference = doubt.likely();
        return meetings_.is_free(patch);
      });
    });
  }

  /// Near a turning point a short time is a shorter way than positions can tell apart.
  bool is_shortest(const Cell& cell) const {
    return cell.to_time - cell.from_time < kShortestCell * longest_ || cell.middle() == cell.from ||
           cell.middle() == cell.to;
  }

  void split(const Cell& cell, const TimedSlice& middle, std::vector<Cell>& halves) {
    learn(middle);
    halves.push_back({cell.leg, cell.from, middle.position, cell.from_time, middle.time});
    halves.push_back({cell.leg, middle.position, cell.to, middle.time, cell.to_time});
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
    const Interval ends = {interval.lower - 2.0 * resolution_, interval.upper};
    for (const TimedSlice& slice : middles_) lowest.push_back(end_of_slice(slice, ends, sign));
    double best = interval.lower;
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
      const bool has_left = i > 0 && follows(leaves_[i - 1], leaves_[i]);
      const bool has_right = i + 1 < leaves_.size() && follows(leaves_[i], leaves_[i + 1]);
      const bool is_minimum = (!has_left || lowest[i] <= lowest[i - 1]) && (!has_right || lowest[i] <= lowest[i + 1]);
      if (!is_minimum || lowest[i] > interval.lower + 2.0 * resolution_) continue;
      const double left = has_left ? leaves_[i - 1].middle() : leaves_[i].from;
      const double right = has_right ? leaves_[i + 1].middle() : leaves_[i].to;
      const Leg& leg = *leaves_[i].leg;
      const auto lowest_at = [&](double position) { return end_of_slice(slice_at(leg, position), ends, sign); };
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
    return {&leg, position, arm_.time_at(leg, position), meetings_.times_at(position)};
  }

  /// The least of sign * (differences that a slice forbids) in an interval; infinite if there is none, as beyond the
  /// tip of the set.
  static double end_of_slice(const TimedSlice& slice, Interval ends, double sign) {
    double lowest = kInfinity;
    for (const Interval& times : slice.others) {
      const double end = sign > 0.0 ? slice.time - times.upper : times.lower - slice.time;
      if (ends.contains(end)) lowest = std::min(lowest, end);
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
  std::vector<Cell> cells_;
  std::vector<Cell> leaves_;
  std::vector<TimedSlice> middles_;  ///< of the leaves
};

}  // namespace

std::optional<IntervalSet> project(const Meetings& meetings, const Profile& arm, const ProjectionRules& rules,
                                   const Budget& budget) {
  if (budget.exhausted()) return std::nullopt;
  return Projection(meetings, arm, rules, budget).run();
}

}  // namespace dualarm
