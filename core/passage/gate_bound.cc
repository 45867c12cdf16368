#include "core/passage/gate_bound.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <optional>

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Part of a duration to which a bound is found.
constexpr double kDurationTolerance = 1e-11;
constexpr std::uintmax_t kMostSteps = 60;
/// Shares with which secants begin, and steps of them.
constexpr double kFirstShare = 0.5;
constexpr int kMostSecants = 16;
/// Secants that may lead beyond the families' ends before an arm counts as one that cannot be hurried more.
constexpr int kMostStrayed = 2;
/// A step in a share that tells slopes: in shorter ones the rounding of times shows.
constexpr double kLeastStep = 1e-8;
/// Halvings of a step that leads to where there is no motion, because the joint range ends.
constexpr int kMostHalvings = 6;

bool is_beyond(const Gate& gate, double position) {
  return gate.runs_up ? position >= gate.corner_position : position <= gate.corner_position;
}

/// A share of a family with its motion, and how fast the times change with the share: by the last two motions.
class Walker {
 public:
  /// From where a walk near by ended, if there was one.
  Walker(const Through& through, const Haste* near_by) : through_(through), passing_(through.least()) {
    if (near_by != nullptr) {
      haste_ = *near_by;
      passing_ = through_.at(haste_.share);
      if (std::isfinite(passing_.duration())) return;
      haste_ = {};
      passing_ = through_.least();
    }
    move_to(kFirstShare);
  }

  const Haste& haste() const { return haste_; }
  const Passing& passing() const { return passing_; }
  double share() const { return haste_.share; }
  double before_slope() const { return haste_.before_slope; }
  double after_slope() const { return haste_.after_slope; }

  /// How much of the price the arm's own duration carries, as a part of the crossing's.
  double carried() const { return -before_or_after() / (before_slope() + after_slope()); }

  /// To a share, or less far where there is no such motion. False if it gets nowhere.
  bool move_to(double share) {
    for (int i = 0; i < kMostHalvings && share != haste_.share; ++i) {
      const double step = share - haste_.share;
      const Passing next = through_.at(share);
      if (std::isfinite(next.duration())) {
        if (std::abs(step) > kLeastStep) {
          haste_.before_slope = (next.before - passing_.before) / step;
          haste_.after_slope = (next.after - passing_.after) / step;
        }
        haste_.share = share;
        passing_ = next;
        return true;
      }
      share = haste_.share + 0.5 * step;
    }
    return share == haste_.share;
  }

 private:
  double before_or_after() const { return through_.is_early() ? before_slope() : after_slope(); }

  const Through& through_;
  Haste haste_;
  Passing passing_;
};

/// A share between 0 and 1: where the secant leads outside, half the way there.
double inside(double share, double from) {
  if (share >= 1.0) return 0.5 * (from + 1.0);
  if (share <= 0.0) return 0.5 * from;
  return share;
}

/// Where both arms take the whole duration and meet in the gate: the first halves and the second halves take equally
/// long. By secants in both shares; nothing where that does not lead to shares between 0 and 1.
std::optional<GateBound> meeting(const Through& early, const Through& late, int early_arm, const GateBound* near_by,
                                 double floor, const Budget& budget) {
  Walker one(early, near_by != nullptr ? &near_by->early_haste : nullptr);
  Walker other(late, near_by != nullptr ? &near_by->late_haste : nullptr);
  int strayed = 0;
  for (int i = 0; i < kMostSecants && !budget.exhausted(); ++i) {
    const double duration = one.passing().before + other.passing().after;
    const double first_halves = other.passing().before - one.passing().before;
    const double second_halves = one.passing().after - other.passing().after;
    if (std::abs(first_halves) + std::abs(second_halves) < kDurationTolerance * duration) {
      const double price = 1.0 / (1.0 + one.carried() + other.carried());
      return GateBound{duration, early_arm, one.passing(), other.passing(), price, one.haste(), other.haste()};
    }
    // Any two motions that meet in the gate show that the bound is no larger.
    const double shown = std::max({duration, one.passing().duration(), other.passing().duration()});
    if (shown <= floor) return GateBound{shown, early_arm, one.passing(), other.passing(), 0.0, {}, {}};
    const double determinant = one.after_slope() * other.before_slope() - one.before_slope() * other.after_slope();
    const double step = -(second_halves * other.before_slope() + first_halves * other.after_slope()) / determinant;
    const double other_step = -(first_halves * one.after_slope() + second_halves * one.before_slope()) / determinant;
    const double next = one.share() + step;
    const double other_next = other.share() + other_step;
    if (!std::isfinite(next) || !std::isfinite(other_next)) return std::nullopt;
    if ((next >= 1.0 || other_next >= 1.0) && ++strayed > kMostStrayed) return std::nullopt;
    if (!one.move_to(inside(next, one.share())) || !other.move_to(inside(other_next, other.share()))) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

/// Where one arm takes the whole duration and the other one, whose half cannot be hurried more, takes less.
std::optional<GateBound> meeting_with_most(const Through& hurrying, const Passing& most, int early_arm,
                                           const Budget& budget) {
  if (!std::isfinite(most.duration())) return std::nullopt;
  Walker walker(hurrying, nullptr);
  int strayed = 0;
  for (int i = 0; i < kMostSecants && !budget.exhausted(); ++i) {
    const Passing& passing = walker.passing();
    const double missing = hurrying.is_early() ? passing.after - most.after : passing.before - most.before;
    const double duration = passing.duration() - missing;
    if (std::abs(missing) < kDurationTolerance * duration) {
      if (most.duration() > duration) return std::nullopt;
      const double price = 1.0 / (1.0 + walker.carried());
      return hurrying.is_early() ? GateBound{duration, early_arm, passing, most, price, walker.haste(), {1.0}}
                                 : GateBound{duration, early_arm, most, passing, price, {1.0}, walker.haste()};
    }
    const double slope = hurrying.is_early() ? walker.after_slope() : walker.before_slope();
    const double next = walker.share() - missing / slope;
    if (!std::isfinite(next) || (next >= 1.0 && ++strayed > kMostStrayed)) return std::nullopt;
    if (!walker.move_to(inside(next, walker.share()))) return std::nullopt;
  }
  return std::nullopt;
}

/// Least duration with which one arm arrives in time for the other to leave.
GateBound least_duration(const Through& early, const Through& late, int early_arm, const GateBound* near_by,
                         double floor, const Budget& budget) {
  const auto bound = [&](double duration, const Passing& one, const Passing& other) {
    return GateBound{duration, early_arm, one, other, 0.0, {}, {}};
  };
  if (!early.exists() || !late.exists()) return bound(kInfinity, early.least(), late.least());
  const double longer = std::max(early.least().duration(), late.least().duration());
  const double unhurried = early.least().before + late.least().after;
  if (unhurried <= std::max(longer, floor)) return bound(std::max(longer, unhurried), early.least(), late.least());
  const bool knows = near_by != nullptr && near_by->price > 0.0 && near_by->early_arm == early_arm;
  const bool both_hurry = !knows || std::max(near_by->early_haste.share, near_by->late_haste.share) < 1.0;
  std::optional<GateBound> met;
  if (both_hurry) met = meeting(early, late, early_arm, knows ? near_by : nullptr, floor, budget);
  if (met && met->duration > longer && met->duration < unhurried) return *met;
  const Passing early_most = early.most();
  const Passing late_most = late.most();
  const double hurried = early_most.before + late_most.after;
  const double least = std::max(longer, hurried);
  if (std::max(early_most.duration(), late_most.duration()) <= least) {
    const double price = hurried >= longer ? 1.0 : 0.0;
    return {least, early_arm, early_most, late_most, price, {1.0}, {1.0}};
  }
  met = meeting_with_most(early, late_most, early_arm, budget);
  if (!met) met = meeting_with_most(late, early_most, early_arm, budget);
  if (met && met->duration > least && met->duration < unhurried) return *met;
  const auto excess = [&](double duration) {
    return duration - early.within(duration, budget).before - late.within(duration, budget).after;
  };
  const double at_least = excess(least);
  if (at_least >= -kDurationTolerance * least)
    return bound(least, early.within(least, budget), late.within(least, budget));
  std::uintmax_t steps = kMostSteps;
  const auto [below, above] = boost::math::tools::toms748_solve(
      excess, least, unhurried, at_least, std::max(0.0, excess(unhurried)),
      [&](double low, double high) { return high - low < kDurationTolerance * high || budget.exhausted(); }, steps);
  return bound(below, early.within(above, budget), late.within(above, budget));
}

GateEstimate unhurried(const Travellers& travellers, const Order& order) {
  const Passing one = fastest_passing(travellers[order.early_arm], order.early_at, Hurry::kEarlyArrival);
  const Passing other = fastest_passing(travellers[1 - order.early_arm], order.late_at, Hurry::kLateDeparture);
  const double crossing = one.before + other.after;
  return {std::max({one.duration(), other.duration(), crossing}), crossing, order.early_arm, one, other};
}

}  // namespace

Orders orders_of(const Travellers& travellers, const Gate& gate) {
  const int pinned = gate.pinned_arm;
  const int other = 1 - pinned;
  Orders orders;
  if (!is_beyond(gate, travellers[other].goal.position)) {
    orders.orders[orders.count++] = {pinned, gate.pinned_position, gate.corner_position};
  }
  if (!is_beyond(gate, travellers[other].start.position)) {
    orders.orders[orders.count++] = {other, gate.corner_position, gate.pinned_position};
  }
  return orders;
}

GateBound gate_bound(const Travellers& travellers, const Gate& gate, const GateBound* near_by, double floor,
                     const Budget& budget) {
  GateBound bound;
  bound.duration = travellers[1 - gate.pinned_arm].fastest.duration();
  const auto [orders, count] = orders_of(travellers, gate);
  if (count == 0) {
    const Through through(travellers[gate.pinned_arm], gate.pinned_position, Hurry::kEarlyArrival);
    bound.duration = std::max(bound.duration, through.least().duration());
    bound.early = through.least();
    return bound;
  }
  std::array<GateEstimate, 2> estimates;
  for (int i = 0; i < count; ++i) estimates[i] = unhurried(travellers, orders[i]);
  // The slower order first: as a rule the other one need not be looked at.
  const int first = count > 1 && estimates[1].duration > estimates[0].duration ? 1 : 0;
  for (int i = 0; i < count; ++i) {
    const int which = i == 0 ? first : 1 - first;
    if (i > 0 && estimates[which].duration <= bound.duration) continue;
    const Order& order = orders[which];
    const GateBound found = least_duration(
        Through(travellers[order.early_arm], order.early_at, Hurry::kEarlyArrival, estimates[which].early),
        Through(travellers[1 - order.early_arm], order.late_at, Hurry::kLateDeparture, estimates[which].late),
        order.early_arm, near_by, floor, budget);
    if (i == 0 || found.duration > bound.duration) bound = found;
  }
  return bound;
}

GateEstimate gate_estimate(const Travellers& travellers, const Gate& gate) {
  const auto [orders, count] = orders_of(travellers, gate);
  if (count == 0) {
    const Passing through = fastest_passing(travellers[gate.pinned_arm], gate.pinned_position, Hurry::kEarlyArrival);
    const double longer = std::max(through.duration(), travellers[1 - gate.pinned_arm].fastest.duration());
    return {longer, through.duration(), gate.pinned_arm, {}, {}};
  }
  GateEstimate estimate;
  for (int i = 0; i < count; ++i) {
    const GateEstimate found = unhurried(travellers, orders[i]);
    const double longer = std::max(estimate.duration, found.duration);
    if (found.crossing > estimate.crossing) estimate = found;
    estimate.duration = longer;
  }
  return estimate;
}

/// Pontryagin's multipliers cancel everything but the time it takes to go on at the velocity in the gate.
double crossing_slope(const Gate& gate, double corner_slope, int early_arm, const Passing& early, const Passing& late) {
  const bool is_pinned_early = early_arm == gate.pinned_arm;
  const double early_moves = is_pinned_early ? 1.0 : corner_slope;
  const double late_moves = is_pinned_early ? corner_slope : 1.0;
  return early_moves / early.velocity - late_moves / late.velocity;
}

}  // namespace dualarm
