#include "core/verification/peak.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/verification/tolerances.h"

namespace dualarm {
namespace {

/// What is not a number uses more than any limit.
double or_infinite(double share) { return std::isnan(share) ? std::numeric_limits<double>::infinity() : share; }

}  // namespace

Share Share::by_side(Interval limits) {
  return limits.lower < 0.0 && 0.0 < limits.upper ? Share(0.0, limits) : from_middle(limits);
}

Share Share::from_middle(Interval limits) { return {0.5 * (limits.lower + limits.upper), limits}; }

double Share::of(double value) const {
  const double used = value - origin_;
  if (used == 0.0) return 0.0;
  return or_infinite(used / ((used > 0.0 ? limits_.upper : limits_.lower) - origin_));
}

double Share::per_unit() const { return 1.0 / std::min(limits_.upper - origin_, origin_ - limits_.lower); }

void PeakSearch::visit(double time, double value) {
  const double share = share_.of(value);
  attain(time, value, share);
  proven_ = std::max(proven_, share);
}

void PeakSearch::visit(const Quantity& quantity, Interval time) {
  search(quantity, time, quantity.value(time.lower), quantity.value(time.upper), 0);
}

void PeakSearch::search(const Quantity& quantity, Interval time, double start, double end, int halvings) {
  const double departure = quantity.curvature(time) * time.length() * time.length() / 8.0;
  const double highest = share_.of(std::max(start, end) + departure);
  const double lowest = share_.of(std::min(start, end) - departure);
  const double rounding = quantity.rounding * share_.per_unit();
  const double bound = or_infinite(std::max(highest, lowest) - rounding);
  const bool is_close = bound <= attained_ + slack_ * std::max(1.0, attained_);
  if (is_close || halvings >= kMostHalvings || attained_ > kHopelessShare) {
    proven_ = std::max(proven_, bound);
    return;
  }
  const double middle_time = 0.5 * (time.lower + time.upper);
  const double middle = quantity.value(middle_time);
  attain(middle_time, middle, share_.of(middle) - rounding);
  search(quantity, {time.lower, middle_time}, start, middle, halvings + 1);
  search(quantity, {middle_time, time.upper}, middle, end, halvings + 1);
}

void PeakSearch::attain(double time, double value, double share) {
  if (!(or_infinite(share) > attained_)) return;
  attained_ = or_infinite(share);
  value_ = value;
  time_ = time;
}

}  // namespace dualarm
