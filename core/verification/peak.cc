#include "core/verification/peak.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/verification/lanes.h"
#include "core/verification/tolerances.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double half_width_of(Interval limits) {
  if (std::isfinite(limits.lower) == std::isfinite(limits.upper)) return 0.5 * limits.upper - 0.5 * limits.lower;
  return std::max(1.0, std::abs(std::isfinite(limits.lower) ? limits.lower : limits.upper));
}

}  // namespace

Share::Share(double origin, Interval limits) : origin_(origin), limits_(limits), half_width_(half_width_of(limits)) {}

Share Share::by_side(Interval limits) {
  return limits.lower <= 0.0 && 0.0 <= limits.upper ? Share(0.0, limits) : from_middle(limits);
}

Share Share::from_middle(Interval limits) { return {0.5 * (limits.lower + limits.upper), limits}; }

double Share::of(double value, double rounding) const {
  const double least = nearest(value, rounding);
  if (std::isnan(least)) return kInfinity;
  if (least > limits_.upper) return or_infinite(1.0 + (least - limits_.upper) / half_width_);
  if (least < limits_.lower) return or_infinite(1.0 + (limits_.lower - least) / half_width_);
  const double used = least - origin_;
  return used == 0.0 ? 0.0 : or_infinite(used / ((used > 0.0 ? limits_.upper : limits_.lower) - origin_));
}

Interval Share::values_within(double share) const {
  if (!(share >= 0.0)) return {kInfinity, -kInfinity};
  const auto beyond = [&](double limit, double sign) {
    if (std::isinf(limit) || std::isinf(share)) return sign * kInfinity;
    return share <= 1.0 ? origin_ + share * (limit - origin_) : limit + sign * (share - 1.0) * half_width_;
  };
  return {beyond(limits_.lower, -1.0), beyond(limits_.upper, 1.0)};
}

double PeakSearch::proven() const {
  if (included_.empty()) return proven_;
  return std::max({proven_, share_.of(included_.lower), share_.of(included_.upper)});
}

void PeakSearch::include(double lowest, double highest) {
  included_ = {std::min(included_.lower, lowest), std::max(included_.upper, highest)};
}

void PeakSearch::visit(double time, double value) {
  if (attained_values_.contains(value)) return include(value, value);
  const double share = share_.of(value);
  attain(time, value, share);
  proven_ = std::max(proven_, share);
}

bool PeakSearch::visit_range(Interval values, double rounding) {
  const double lowest = share_.nearest(values.lower, rounding);
  const double highest = share_.nearest(values.upper, rounding);
  if (!enough_values_.contains(lowest) || !enough_values_.contains(highest)) return false;
  include(lowest, highest);
  return true;
}

void PeakSearch::visit(const Quantity& quantity, Interval time) {
  search(quantity, time, quantity.value(time.lower), quantity.value(time.upper), 0);
}

void PeakSearch::search(const Quantity& quantity, Interval time, double start, double end, int halvings) {
  const double departure = quantity.curvature(time) * time.length() * time.length() / 8.0;
  const double highest = share_.of(std::max(start, end) + departure, quantity.rounding);
  const double lowest = share_.of(std::min(start, end) - departure, quantity.rounding);
  const double bound = std::max(highest, lowest);
  if (is_close(bound) || halvings >= kMostHalvings || attained_ > kHopelessShare) {
    proven_ = std::max(proven_, bound);
    return;
  }
  const double middle_time = 0.5 * (time.lower + time.upper);
  const double middle = quantity.value(middle_time);
  attain(middle_time, middle, share_.of(middle, quantity.rounding));
  search(quantity, {time.lower, middle_time}, start, middle, halvings + 1);
  search(quantity, {middle_time, time.upper}, middle, end, halvings + 1);
}

void PeakSearch::attain(double time, double value, double share) {
  if (!(or_infinite(share) > attained_)) return;
  set_attained(or_infinite(share));
  value_ = value;
  time_ = time;
}

void PeakSearch::set_attained(double share) {
  attained_ = share;
  attained_values_ = share_.values_within(attained_);
  enough_values_ = share_.values_within(enough());
}

}  // namespace dualarm
