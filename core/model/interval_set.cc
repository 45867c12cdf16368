#include "core/model/interval_set.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace dualarm {

IntervalSet::IntervalSet(std::vector<Interval> intervals) : intervals_(std::move(intervals)) {
  std::erase_if(intervals_, [](const Interval& interval) { return interval.empty(); });
  std::sort(intervals_.begin(), intervals_.end(),
            [](const Interval& left, const Interval& right) { return left.lower < right.lower; });
  std::size_t count = 0;  // of those that are united already
  for (const Interval& interval : intervals_) {
    if (count > 0 && interval.lower <= intervals_[count - 1].upper) {
      intervals_[count - 1].upper = std::max(intervals_[count - 1].upper, interval.upper);
    } else {
      intervals_[count++] = interval;
    }
  }
  intervals_.resize(count);
}

bool IntervalSet::contains(double value) const {
  return std::any_of(intervals_.begin(), intervals_.end(), [&](const Interval& i) { return i.contains(value); });
}

bool IntervalSet::contains_inside(double value) const {
  return std::any_of(intervals_.begin(), intervals_.end(),
                     [&](const Interval& i) { return i.lower < value && value < i.upper; });
}

bool IntervalSet::covers(Interval interval, double tolerance) const {
  // Of the intervals that begin early enough, the last two can cover it: the last may begin within the tolerance only.
  auto after = std::upper_bound(intervals_.begin(), intervals_.end(), interval.lower + tolerance,
                                [](double value, const Interval& i) { return value < i.lower; });
  for (int i = 0; i < 2 && after != intervals_.begin(); ++i) {
    --after;
    if (interval.upper <= after->upper + tolerance) return true;
  }
  return false;
}

IntervalSet IntervalSet::complement(Interval within) const {
  std::vector<Interval> gaps;
  double from = within.lower;
  for (const Interval& interval : intervals_) {
    if (interval.upper < within.lower || interval.lower > within.upper) continue;
    if (interval.lower >= from) gaps.push_back({from, interval.lower});
    from = interval.upper;
  }
  if (from <= within.upper) gaps.push_back({from, within.upper});
  // An infinite end is not a point that anything can stand on.
  std::erase_if(gaps, [](const Interval& gap) { return gap.lower == gap.upper && gap.lower - gap.lower != 0.0; });
  return IntervalSet(std::move(gaps));
}

IntervalSet unite_across(std::vector<Interval> intervals, double gap) {
  for (Interval& interval : intervals) interval.upper += gap;
  std::vector<Interval> united = IntervalSet(std::move(intervals)).intervals();
  for (Interval& interval : united) interval.upper -= gap;
  return IntervalSet(std::move(united));
}

IntervalSet unite(const IntervalSet& first, const IntervalSet& second) {
  std::vector<Interval> all = first.intervals();
  all.insert(all.end(), second.intervals().begin(), second.intervals().end());
  return IntervalSet(std::move(all));
}

}  // namespace dualarm
