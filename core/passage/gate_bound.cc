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
/// Halvings of a step that leads to where there is no motion, because the joint range ends.
constexpr int kMostHalvings = 6;

bool is_beyond(const Gate& gate, double position) {
  return gate.runs_up ? position >= gate.corner_position : position <= gate.corner_position;
}

/// A share of a family with its motion, and how fast the times change with the share: by the last two motions.
class Walker {
 public:
  explicit Walker(const Through& through) : through_(through), passing_(through.least()) { move_to(kFirstShare); }

  double share() const { return share_; }
  const Passing& passing() const { return passing_; }
  double before_slope() const { return before_slope_; }
  double after_slope() const { return after_slope_; }

  /// To a share, or less far where there is no such motion. False if it gets nowhere.
  bool move_to(double share) {
    for (int i = 0; i < kMostHalvings && share != share_; ++i) {
      const double step = share - share_;
      const Passing next = through_.at(share);
      if (std::isfinite(next.duration())) {
        before_slope_ = (next.before - passing_.before) / step;
        after_slope_ = (next.after - passing_.after) / step;
        share_ = share;
        passing_ = next;
        return true;
      }
      share = share_ + 0.5 * step;
    }
    return share == share_;
  }

 private:
  const Through& through_;
  double share_ = 0.0;
  Passing passing_;
  double before_slope_ = 0.0;
  double after_slope_ = 0.0;
};

/// A share between 0 and 1: where the secant leads outside, half the way there.
double inside(double share, double from) {
  if (share >= 1.0) return 0.5 * (from + 1.0);
  if (share <= 0.0) return 0.5 * from;
  return share;
}

/// Where both arms take the whole duration and meet in the gate: the first halves and the second halves take equally
/// long. By secants in both shares; nothing where that does not lead to shares between 0 and 1.
std::optional<GateBound> meeting(const Through& early, const Through& late, int early_arm) {
  Walker one(early);
  Walker other(late);
  for (int i = 0; i < kMostSecants; ++i) {
    const double duration = one.passing().before + other.passing().after;
    const double first_halves = other.passing().before - one.passing().before;
    const double second_halves = one.passing().after - other.passing().after;
    if (std::abs(first_halves) + std::abs(second_halves) < kDurationTolerance * duration) {
      return GateBound{duration, early_arm, one.passing(), other.passing()};
    }
    const double determinant = one.after_slope() * other.before_slope() - one.before_slope() * other.after_slope();
    const double step = -(second_halves * other.before_slope() + first_halves * other.after_slope()) / determinant;
    const double other_step = -(first_halves * one.after_slope() + second_halves * one.before_slope()) / determinant;
    const double next = one.share() + step;
    const double other_next = other.share() + other_step;
    if (!std::isfinite(next) || !std::isfinite(other_next)) return std::nullopt;
    if (!one.move_to(inside(next, one.share())) || !other.move_to(inside(other_next, other.share()))) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

/// Where one arm takes the whole duration and the other one, whose half cannot be hurried more, takes less.
std::optional<GateBound> meeting_with_most(const Through& hurrying, const Passing& most, bool is_early, int early_arm) {
  if (!std::isfinite(most.duration())) return std::nullopt;
  Walker walker(hurrying);
  for (int i = 0; i < kMostSecants; ++i) {
    const Passing& passing = walker.passing();
    const double missing = is_early ? passing.after - most.after : passing.before - most.before;
    const double duration = passing.duration() - missing;
    if (std::abs(missing) < kDurationTolerance * duration) {
      if (most.duration() > duration) return std::nullopt;
      return is_early ? GateBound{duration, early_arm, passing, most} : GateBound{duration, early_arm, most, passing};
    }
    const double next = walker.share() - missing / (is_early ? walker.after_slope() : walker.before_slope());
    if (!std::isfinite(next) || !walker.move_to(inside(next, walker.share()))) return std::nullopt;
  }
  return std::nullopt;
}

/// Least duration with which one arm arrives in time for the other to leave.
GateBound least_duration(const Through& early, const Through& late, int early_arm) {
  const auto bound = [&](double duration, const Passing& one, const Passing& other) {
    return GateBound{duration, early_arm, one, other};
  };
  if (!early.exists() || !late.exists()) return bound(kInfinity, early.least(), late.least());
  const double longer = std::max(early.least().duration(), late.least().duration());
  const double unhurried = early.least().before + late.least().after;
  if (unhurried <= longer) return bound(longer, early.least(), late.least());
  const double least = std::max(longer, early.most().before + late.most().after);
  auto met = meeting(early, late, early_arm);
  if (!met) met = meeting_with_most(early, late.most(), true, early_arm);
  if (!met) met = meeting_with_most(late, early.most(), false, early_arm);
  if (met && met->duration > least && met->duration < unhurried) return *met;
  const auto excess = [&](double duration) {
    return duration - early.within(duration).before - late.within(duration).after;
  };
  const double at_least = excess(least);
  if (at_least >= -kDurationTolerance * least) return bound(least, early.within(least), late.within(least));
  std::uintmax_t steps = kMostSteps;
  const auto [below, above] = boost::math::tools::toms748_solve(
      excess, least, unhurried, at_least, std::max(0.0, excess(unhurried)),
      [](double low, double high) { return high - low < kDurationTolerance * high; }, steps);
  return bound(below, early.within(above), late.within(above));
}

GateEstimate unhurried(const Traveller& early, double early_at, const Traveller& late, double late_at) {
  const Passing one = fastest_passing(early, early_at, Hurry::kEarlyArrival);
  const Passing other = fastest_passing(late, late_at, Hurry::kLateDeparture);
  const double crossing = one.before + other.after;
  return {std::max({one.duration(), other.duration(), crossing}), crossing};
}

}  // namespace

GateBound gate_bound(const Travellers& travellers, const Gate& gate) {
  const int pinned = gate.pinned_arm;
  const int other = 1 - pinned;
  const Traveller& at_pin = travellers[pinned];
  const Traveller& beyond = travellers[other];
  const bool starts_beyond = is_beyond(gate, beyond.start.position);
  const bool ends_beyond = is_beyond(gate, beyond.goal.position);
  GateBound bound;
  bound.duration = beyond.fastest.duration();
  if (!ends_beyond) {
    bound = least_duration(Through(at_pin, gate.pinned_position, Hurry::kEarlyArrival),
                           Through(beyond, gate.corner_position, Hurry::kLateDeparture), pinned);
  }
  if (!starts_beyond) {
    const GateBound reverse = least_duration(Through(beyond, gate.corner_position, Hurry::kEarlyArrival),
                                             Through(at_pin, gate.pinned_position, Hurry::kLateDeparture), other);
    if (reverse.duration > bound.duration) bound = reverse;
  }
  if (starts_beyond && ends_beyond) {
    const Through through(at_pin, gate.pinned_position, Hurry::kEarlyArrival);
    bound.duration = std::max(bound.duration, through.least().duration());
    bound.early = through.least();
  }
  return bound;
}

GateEstimate gate_estimate(const Travellers& travellers, const Gate& gate) {
  const Traveller& at_pin = travellers[gate.pinned_arm];
  const Traveller& beyond = travellers[1 - gate.pinned_arm];
  const bool starts_beyond = is_beyond(gate, beyond.start.position);
  const bool ends_beyond = is_beyond(gate, beyond.goal.position);
  if (starts_beyond && ends_beyond) {
    const double through = fastest_passing(at_pin, gate.pinned_position, Hurry::kEarlyArrival).duration();
    return {std::max(through, beyond.fastest.duration()), through};
  }
  GateEstimate estimate;
  if (!ends_beyond) estimate = unhurried(at_pin, gate.pinned_position, beyond, gate.corner_position);
  if (!starts_beyond) {
    const GateEstimate reverse = unhurried(beyond, gate.corner_position, at_pin, gate.pinned_position);
    estimate = {std::max(estimate.duration, reverse.duration), std::max(estimate.crossing, reverse.crossing)};
  }
  return estimate;
}

}  // namespace dualarm
