#include "core/verification/torque_peak.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/verification/tolerances.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What a quantity does in `half` an interval to either side of its middle. Where its rate keeps its sign, the ends say
/// it exactly.
Interval reached(double start, double end, double middle, double rate, double most_change, double half) {
  if (std::abs(rate) > most_change * half) return {std::min(start, end), std::max(start, end)};
  const double way = (std::abs(rate) + 0.5 * most_change * half) * half;
  return {middle - way, middle + way};
}

/// Bound on |D''| within `half` an interval of the middle of a piece, N m/s2. `limit` is about the state there.
double most_curvature(const JointTorque& torque, const Bilinear& limit, const Quintic& piece, double middle,
                      double half) {
  const double of_limit = limit.per_position * piece.derivative(2, middle) +
                          limit.per_velocity * piece.derivative(3, middle) +
                          2.0 * limit.mixed * piece.derivative(1, middle) * piece.derivative(2, middle);
  const double most_way = piece.most(1) * half;
  const double most_gain = piece.most(2) * half;
  const double most_mixed = piece.most(3) * most_gain + 3.0 * piece.most(2) * piece.most(2) +
                            3.0 * piece.most(1) * piece.most(3) + most_way * piece.most(4);
  const double most_third = torque.most_third_derivative(piece) + std::abs(limit.per_position) * piece.most(3) +
                            std::abs(limit.per_velocity) * piece.most(4) + std::abs(limit.mixed) * most_mixed;
  return std::abs(torque.second_derivative(piece, middle) - of_limit) + most_third * half;
}

/// Share that is used at most where the torque is beyond the limit of a share of `aim` by at most `excess` (N m,
/// perhaps below zero). `limits` are the extremes of the limit's magnitude, `half_widths` those of half the width.
double share_beyond(double aim, double excess, bool is_by_side, Interval limits, Interval half_widths) {
  if (!std::isfinite(excess)) return kInfinity;
  const auto at_most = [excess](double from, Interval units) {
    return from + excess / (excess > 0.0 ? units.lower : units.upper);
  };
  if (!is_by_side) return std::max(0.0, at_most(aim, half_widths));
  if (aim > 1.0) return std::max(1.0, at_most(aim, half_widths));
  if (excess <= 0.0) return limits.upper > 0.0 ? std::max(0.0, at_most(aim, limits)) : 0.0;
  const double inside = limits.lower > 0.0 ? at_most(aim, limits) : kInfinity;
  return inside <= 1.0 ? inside : at_most(1.0, half_widths);
}

/// The slack that rounding of limits asks for where they are narrow: 100 last digits of their magnitude.
double rounding_slack(const TorqueLimit& limit) {
  const Interval bounds = torque_bounds(limit);
  return 100.0 * std::numeric_limits<double>::epsilon() * std::max(-bounds.lower, bounds.upper) /
         least_half_width(limit);
}

bool contain_zero_everywhere(const TorqueLimit& limit) {
  const auto* table = std::get_if<TorqueTable>(&limit);
  if (table == nullptr) return torque_bounds(limit).contains(0.0);
  return std::all_of(table->limits.begin(), table->limits.end(),
                     [](const Interval& limits) { return limits.contains(0.0); });
}

}  // namespace

double least_half_width(const TorqueLimit& limit) {
  if (const auto* constant = std::get_if<Interval>(&limit)) return Share::by_side(*constant).unit();
  if (const auto* line = std::get_if<TorqueSpeedLine>(&limit)) return 0.5 * line->stall_torque;
  const std::vector<Interval>& limits = std::get<TorqueTable>(limit).limits;
  const auto narrower = [](const Interval& a, const Interval& b) { return a.length() < b.length(); };
  return 0.5 * std::min_element(limits.begin(), limits.end(), narrower)->length();
}

TorquePeakSearch::TorquePeakSearch(const JointTorque& torque, const TorqueLimit& limit, double slack)
    : torque_(torque),
      cells_(limit),
      is_by_side_(contain_zero_everywhere(limit)),
      slack_(slack + rounding_slack(limit)) {}

void TorquePeakSearch::visit(double time, JointState state, double torque) {
  attain({time, state, torque}, 0.0);
  proven_ = std::max(proven_, attained_);
}

void TorquePeakSearch::visit(const Quintic& piece, double rounding) {
  if (!std::isfinite(piece.most(5))) {  // halving would not help
    proven_ = kInfinity;
    return;
  }
  intervals_left_ = kMostIntervals;
  search(piece, rounding, instant(piece, piece.time().lower), instant(piece, piece.time().upper), 0);
}

TorquePeakSearch::Instant TorquePeakSearch::instant(const Quintic& piece, double time) const {
  const JointState state = {piece.derivative(0, time), piece.derivative(1, time)};
  return {time, state, torque_.at(state, piece.derivative(2, time))};
}

Share TorquePeakSearch::share_at(Interval limits) const {
  return is_by_side_ ? Share::by_side(limits) : Share::from_middle(limits);
}

void TorquePeakSearch::attain(const Instant& at, double rounding) {
  const Interval limits = cells_.at(at.state);
  const double share = share_at(limits).of(at.torque, rounding);
  if (!(share > attained_)) return;
  attained_ = share;
  value_ = at.torque;
  limits_ = limits;
  time_ = at.time;
}

void TorquePeakSearch::search(const Quintic& piece, double rounding, const Instant& start, const Instant& end,
                              int halvings) {
  const Instant middle = instant(piece, 0.5 * (start.time + end.time));
  const double aim = std::max(0.0, attained_) + slack_ * std::max(1.0, attained_);
  const double most = bound(piece, rounding, start, end, middle, aim);
  if (most <= aim || halvings >= kMostBendHalvings || --intervals_left_ < 0 || attained_ > kHopelessShare) {
    proven_ = std::max(proven_, most);
    return;
  }
  attain(middle, rounding);
  search(piece, rounding, start, middle, halvings + 1);
  search(piece, rounding, middle, end, halvings + 1);
}

double TorquePeakSearch::bound(const Quintic& piece, double rounding, const Instant& start, const Instant& end,
                               const Instant& middle, double aim) const {
  const double h = end.time - start.time;
  const Interval positions = reached(start.state.position, end.state.position, middle.state.position,
                                     middle.state.velocity, piece.most(2), 0.5 * h);
  const Interval velocities = reached(start.state.velocity, end.state.velocity, middle.state.velocity,
                                      piece.derivative(2, middle.time), piece.most(3), 0.5 * h);
  const auto over = cells_.over(positions, velocities, middle.state);
  if (!over) return kInfinity;

  // The limit at a share of `aim`, as a sum of the limit of that side and of the other.
  const bool scales = is_by_side_ && aim <= 1.0;
  const double of_this = scales ? aim : 0.5 * (1.0 + aim);
  const double of_other = scales ? 0.0 : 0.5 * (1.0 - aim);
  const auto excess = [&](double side, const Bilinear& this_limit, const Bilinear& other_limit, double error) {
    const Bilinear limit = of_this * this_limit + of_other * other_limit;
    const double chord =
        std::max(side * (start.torque - limit.at(start.state)), side * (end.torque - limit.at(end.state)));
    return chord + most_curvature(torque_, limit, piece, middle.time, 0.5 * h) * h * h / 8.0 + error - rounding;
  };
  const double of_lower = std::abs(of_other) * over->upper_error + of_this * over->lower_error;
  const double of_upper = of_this * over->upper_error + std::abs(of_other) * over->lower_error;
  const double above = excess(1.0, over->upper, over->lower, of_upper);
  const double below = excess(-1.0, over->lower, over->upper, of_lower);
  const Interval depths = {-over->lower_extremes.upper, -over->lower_extremes.lower};
  return std::max(share_beyond(aim, above, is_by_side_, over->upper_extremes, over->half_width_extremes),
                  share_beyond(aim, below, is_by_side_, depths, over->half_width_extremes));
}

}  // namespace dualarm
