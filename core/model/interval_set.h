#pragma once

#include <utility>
#include <vector>

#include "geometry/interval.h"

namespace dualarm {

/// A union of closed intervals of real numbers: sorted, disjoint, never touching. Ends may be infinite.
class IntervalSet {
 public:
  IntervalSet() = default;

  /// Any intervals, in any order, overlapping or not; empty ones are dropped.
  explicit IntervalSet(std::vector<Interval> intervals);

  const std::vector<Interval>& intervals() const& { return intervals_; }
  std::vector<Interval> intervals() && { return std::move(intervals_); }  // safe in a range-for over a temporary

  bool empty() const { return intervals_.empty(); }
  bool contains(double value) const;

  /// True if the value lies inside an interval and not on its ends.
  bool contains_inside(double value) const;

  /// True if one interval of the set covers the whole of `interval`, each end to a tolerance >= 0.
  bool covers(Interval interval, double tolerance = 0.0) const;

  /// Closures of the gaps: the points of `within` that lie in no interval's interior.
  IntervalSet complement(Interval within) const;

 private:
  std::vector<Interval> intervals_;
};

/// The union of any intervals, in any order, with gaps of at most `gap` (>= 0) between them closed.
IntervalSet unite_across(std::vector<Interval> intervals, double gap);

/// Every point of either.
IntervalSet unite(const IntervalSet& first, const IntervalSet& second);

}  // namespace dualarm
