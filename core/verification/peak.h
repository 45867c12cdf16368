#pragma once

#include <algorithm>
#include <functional>
#include <limits>

#include "geometry/interval.h"

namespace dualarm {

/// How much of a limit a value uses: 1 at the limit, more outside, 0 where nothing is used. What is outside counts
/// against half the width of the limits on either side, so that a side of next to nothing does not magnify rounding.
class Share {
 public:
  /// By side: value / upper above zero, value / lower below; nothing is used of an infinite limit. Where one side is
  /// infinite, the width is twice the other (at least 2 units). Limits without zero are judged from their middle.
  static Share by_side(Interval limits);

  /// Distance from the middle of the limits over half their width.
  static Share from_middle(Interval limits);

  /// The least share of what is within `rounding` of a value.
  double of(double value, double rounding = 0.0) const;

  /// The values that use no more than a share; none below a share of 0.
  Interval values_within(double share) const;

  /// What is within `rounding` of a value and uses least; what is not a number stays so.
  double nearest(double value, double rounding) const {
    if (value > origin_) return std::max(origin_, value - rounding);
    return value <= origin_ ? std::min(origin_, value + rounding) : value;
  }

  /// What a share of 1 outside of the limits is in units of the value: half the width of the limits.
  double unit() const { return half_width_; }

 private:
  Share(double origin, Interval limits);

  double origin_;
  Interval limits_;
  double half_width_;
};

/// A quantity along a stretch of time, as functions of time (s).
struct Quantity {
  std::function<double(double)> value;
  std::function<double(Interval)> curvature;  ///< bound on the magnitude of the second derivative, unit/s2
  double rounding = 0.0;                      ///< what the last digits of the knots may do to the value
};

/// Searches the largest share of a limit that a quantity uses, and proves it: over an interval of length h a quantity
/// stays within curvature * h^2 / 8 of its chord. Intervals whose bound could still exceed what is attained are halved.
/// Values that cannot are only compared with others; the share of the extreme ones is taken in the end.
class PeakSearch {
 public:
  /// The proven peak exceeds the attained one by at most `slack` (share, relative above 1).
  PeakSearch(Share share, double slack) : share_(share), slack_(slack) { set_attained(-1.0); }

  /// A value that is taken at a time.
  void visit(double time, double value);

  /// Whether values that a quantity stays within, but for `rounding`, are proof enough: then they are visited.
  bool visit_range(Interval values, double rounding);

  /// All that the quantity does during an interval of time.
  void visit(const Quantity& quantity, Interval time);

  /// Values that need no closer look.
  Interval enough_values() const { return enough_values_; }

  double proven() const;                   ///< upper bound on the share
  double value() const { return value_; }  ///< of the quantity where the largest share was seen
  double time() const { return time_; }    ///< s, where that is

 private:
  void search(const Quantity& quantity, Interval time, double start, double end, int halvings);
  double enough() const { return attained_ + slack_ * std::max(1.0, attained_); }
  bool is_close(double bound) const { return bound <= enough(); }
  void attain(double time, double value, double share);
  void set_attained(double share);
  void include(double lowest, double highest);

  Share share_;
  double slack_;
  double attained_;
  Interval attained_values_;  ///< all that use no more
  Interval enough_values_;    ///< all that are proof enough
  Interval included_ = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  double proven_ = 0.0;  ///< of what is not included there
  double value_ = 0.0;
  double time_ = 0.0;
};

}  // namespace dualarm
