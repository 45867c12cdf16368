#include "core/passage/slowest_gate.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

#include "core/passage/climb.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Parts into which candidates for gates divide an obstacle's extent.
constexpr int kSpread = 10;
/// Bits of the position to which the slowest gate is found, and steps of that search.
constexpr int kGateBits = 26;
constexpr std::uintmax_t kMostSteps = 50;
/// Part of a duration that is worth looking for a better gate.
constexpr double kHurried = 1e-9;
/// Climbs along an obstacle's border, rad and parts of a duration: no body moves by a part of the planning margin in so
/// little. The first step of one that begins at the slowest gate of a set that is a margin wider.
constexpr ClimbRules kClimb = {1e-2, 2e-9, 1e-10};
constexpr ClimbRules kRefine = {3e-4, 2e-9, 1e-10};
constexpr ClimbRules kClimbNearBy = {1e-5, 1e-8, 1e-9};
/// Steps along the border to where a pair at given velocities touches it, and how often the pair is found anew there.
constexpr ClimbRules kTouch = {1e-6, 2e-9, 1e-10};
constexpr int kMostTouches = 6;
/// rad: how far apart two slices tell the slope of a border.
constexpr double kBorderStep = 1e-8;

struct Candidate {
  Gate gate;
  GateEstimate estimate;
};

/// A gate, and by how much (s) the time to it and on from it is longer than that of another gate.
struct Touch {
  Gate gate;
  double gain = 0.0;
};

Gate gate_on(const Slice& slice, bool runs_up) {
  return {slice.pinned_arm, slice.position, runs_up ? slice.forbidden.upper : slice.forbidden.lower, runs_up};
}

/// Whether the other arm can be beyond the corner at all.
bool leads_on(const ForbiddenPlane& plane, const Gate& gate) {
  const Interval range = plane.range(1 - gate.pinned_arm);
  return gate.runs_up ? gate.corner_position < range.upper : gate.corner_position > range.lower;
}

/// Seeks the slowest gate of one side of one obstacle.
class SideSearch {
 public:
  SideSearch(const ForbiddenPlane& plane, const Travellers& travellers, Obstacle& obstacle, int side,
             const Budget& budget)
      : plane_(plane), travellers_(travellers), obstacle_(obstacle), side_(side), budget_(budget) {}

  /// Nothing if no gate of that side is known. Begins at the slowest gate of a set like this one, if there is one of
  /// this side near by.
  std::optional<Way> run(const std::vector<Way>& near_by) {
    bool is_touched = true;
    for (const Way& way : near_by) {
      for (const Gate& gate : gates_at(way.gate, way.gate.pinned_position)) {
        const auto touch = touch_of({gate, way.bound}, plane_.range(gate.pinned_arm));
        consider(touch ? touch->gate : gate, &way.bound);
        is_touched = is_touched && touch;
      }
    }
    if (best_) {
      if (!is_touched) refine_by_bounds(plane_.range(best_->gate.pinned_arm), kClimbNearBy);
      return best_;
    }
    const std::vector<Candidate> candidates = all_candidates();
    if (candidates.empty()) return std::nullopt;
    consider(most_crossing(candidates), nullptr);
    refine_if_hurried(candidates);
    const double refined = best_->bound.duration;
    best_->pair = extremal_pair_of(*best_, candidates);
    const std::optional<ExtremalPair> extremal = best_->pair;
    for (const Candidate& candidate : candidates) {
      if (candidate.estimate.duration <= best_->bound.duration || budget_.exhausted()) break;
      if (extremal && passes_in_turn(*extremal, travellers_, candidate.gate)) continue;
      const GateBound slowest = best_->bound;
      consider(candidate.gate, &slowest, slowest.duration);
    }
    if (best_->bound.duration > refined) refine_if_hurried(candidates);
    return best_;
  }

 private:
  /// Gates at the slices that are known and at positions spread over the obstacle, the slowest by estimate first.
  std::vector<Candidate> all_candidates() {
    std::vector<Slice> slices = obstacle_.slices();
    for (int arm = 0; arm < kArmCount; ++arm) {
      const Interval extent = obstacle_.extent(arm);
      for (int i = 1; i < kSpread; ++i) {
        const double position = extent.lower + extent.length() * i / kSpread;
        for (const Interval& stretch : plane_.slice(arm, position).intervals()) {
          slices.push_back({arm, position, stretch});
        }
      }
    }
    std::vector<Candidate> candidates;
    for (const Slice& slice : slices) {
      for (const bool runs_up : {false, true}) {
        if (budget_.exhausted()) break;
        const Gate gate = gate_on(slice, runs_up);
        if (!leads_on(plane_, gate) || obstacle_.side_of(slice, runs_up) != side_) continue;
        candidates.push_back({gate, gate_estimate(travellers_, gate)});
      }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.estimate.duration > b.estimate.duration; });
    return candidates;
  }

  /// The pair that shows of most other gates that they ask for no more; nothing where no gate is left to be shown.
  std::optional<ExtremalPair> extremal_pair_of(const Way& way, const std::vector<Candidate>& candidates) const {
    if (candidates.front().estimate.duration <= way.bound.duration) return std::nullopt;
    return extremal_pair(travellers_, way.gate, way.bound, way.bound.duration);
  }

  /// A gate of which nothing counts but a bound beyond `floor` (s) costs less.
  GateBound consider(const Gate& gate, const GateBound* near_by, double floor = 0.0) {
    const GateBound bound = gate_bound(travellers_, gate, near_by, floor, budget_);
    if (!best_ || bound.duration > best_->bound.duration) best_ = Way{gate, bound};
    return bound;
  }

  /// The gate at which unhurried motions meet the obstacle most.
  Gate most_crossing(const std::vector<Candidate>& candidates) {
    Candidate most = *std::max_element(
        candidates.begin(), candidates.end(),
        [](const Candidate& a, const Candidate& b) { return a.estimate.crossing < b.estimate.crossing; });
    const Gate like = most.gate;
    const auto crossing_at = [&](double position) {
      std::optional<Rated> found;
      for (const Gate& gate : gates_at(like, position)) {
        const GateEstimate estimate = gate_estimate(travellers_, gate);
        if (estimate.crossing > most.estimate.crossing) most = {gate, estimate};
        if (found && estimate.crossing <= found->value) continue;
        const double slope = slope_at(gate, estimate.early_arm, estimate.early, estimate.late);
        found = {position, estimate.crossing, slope};
      }
      return found;
    };
    seek(crossing_at, neighbourhood(candidates, like), crossing_at(like.pinned_position), kClimb);
    return most.gate;
  }

  void refine_if_hurried(const std::vector<Candidate>& candidates) {
    const double unhurried = gate_estimate(travellers_, best_->gate).duration;
    if (best_->bound.duration >= unhurried * (1.0 - kHurried)) return;
    refine(neighbourhood(candidates, best_->gate), kRefine);
  }

  /// As to the bound itself: it may be largest a little beside where unhurried motions meet.
  void refine(Interval bracket, const ClimbRules& rules) {
    if (!refine_by_touches(bracket)) refine_by_bounds(bracket, rules);
  }

  /// To where the pair's motion touches the border, again and again: that is the slowest gate if the velocities there
  /// are those of its own pair, and they change little on the way. False if it leads nowhere.
  bool refine_by_touches(Interval bracket) {
    for (int i = 0; i < kMostTouches && !budget_.exhausted(); ++i) {
      const Way last = *best_;
      const auto touch = touch_of(last, bracket);
      if (!touch) return false;
      if (last.bound.price * touch->gain <= kTouch.part * last.bound.duration) return true;
      consider(touch->gate, &last.bound);
      if (best_->bound.duration <= last.bound.duration) return false;
    }
    return false;
  }

  /// The gate that a pair at the velocities of another one's would pass last, and what it gains, s. Nothing where those
  /// say nothing.
  std::optional<Touch> touch_of(const Way& way, Interval bracket) {
    const GateBound& bound = way.bound;
    if (!(bound.price > 0.0) || bound.early.velocity == 0.0 || bound.late.velocity == 0.0) return std::nullopt;
    const auto crossing = [&](const Gate& gate) {
      return (position_of(gate, bound.early_arm) - position_of(way.gate, bound.early_arm)) / bound.early.velocity -
             (position_of(gate, 1 - bound.early_arm) - position_of(way.gate, 1 - bound.early_arm)) /
                 bound.late.velocity;
    };
    Touch most = {way.gate, 0.0};
    const auto crossing_at = [&](double position) {
      std::optional<Rated> found;
      for (const Gate& gate : gates_at(way.gate, position)) {
        const double gain = crossing(gate);
        if (gain > most.gain) most = {gate, gain};
        if (!found || gain > found->value) found = Rated{position, gain, slope_at(gate, bound)};
      }
      return found;
    };
    const ClimbRules rules = {kTouch.first_step, kTouch.same, 0.0, kTouch.part * bound.duration};
    if (!climb(crossing_at, bracket, crossing_at(way.gate.pinned_position), rules)) return std::nullopt;
    return most;
  }

  void refine_by_bounds(Interval bracket, const ClimbRules& rules) {
    const Gate like = best_->gate;
    GateBound last = best_->bound;
    const auto bound_at = [&](double position) {
      std::optional<Rated> found;
      for (const Gate& gate : gates_at(like, position)) {
        const GateBound bound = consider(gate, &last);
        if (found && bound.duration <= found->value) continue;
        last = bound;
        found = rated({gate, bound});
      }
      return found;
    };
    seek(bound_at, bracket, rated(*best_), rules);
  }

  Rated rated(const Way& way) const {
    const GateBound& bound = way.bound;
    const double slope = bound.price * slope_at(way.gate, bound);
    return {way.gate.pinned_position, bound.duration, bound.price > 0.0 ? slope : kInfinity};
  }

  /// How fast the time to a gate and on from it grows along the border.
  double slope_at(const Gate& gate, int early_arm, const Passing& early, const Passing& late) const {
    for (const double step : {kBorderStep, -kBorderStep}) {
      double nearest = kInfinity;
      for (const Interval& stretch : plane_.slice(gate.pinned_arm, gate.pinned_position + step).intervals()) {
        const double corner = gate.runs_up ? stretch.upper : stretch.lower;
        if (std::abs(corner - gate.corner_position) < std::abs(nearest)) nearest = corner - gate.corner_position;
      }
      if (std::isfinite(nearest)) return crossing_slope(gate, nearest / step, early_arm, early, late);
    }
    return kInfinity;
  }
  double slope_at(const Gate& gate, const GateBound& bound) const {
    return slope_at(gate, bound.early_arm, bound.early, bound.late);
  }

  /// From one neighbour of a gate that runs the same way to the other.
  Interval neighbourhood(const std::vector<Candidate>& candidates, const Gate& gate) const {
    Interval bracket = plane_.range(gate.pinned_arm);
    for (const Candidate& candidate : candidates) {
      if (candidate.gate.pinned_arm != gate.pinned_arm || candidate.gate.runs_up != gate.runs_up) continue;
      const double position = candidate.gate.pinned_position;
      if (position < gate.pinned_position) bracket.lower = std::max(bracket.lower, position);
      if (position > gate.pinned_position) bracket.upper = std::min(bracket.upper, position);
    }
    return bracket;
  }

  /// By slopes; by values, where there are none.
  template <class Rate>
  void seek(const Rate& rate, Interval bracket, const std::optional<Rated>& from, const ClimbRules& rules) const {
    const auto rate_in_time = [&](double position) {
      return budget_.exhausted() ? std::optional<Rated>() : rate(position);
    };
    if (climb(rate_in_time, bracket, from, rules) || &rules == &kClimbNearBy) return;
    std::uintmax_t steps = kMostSteps;
    const auto fall = [&](double position) {
      const std::optional<Rated> rated = rate_in_time(position);
      return rated ? -rated->value : 0.0;
    };
    boost::math::tools::brent_find_minima(fall, bracket.lower, bracket.upper, kGateBits, steps);
  }

  /// The gates of this side that run like `gate` from a position.
  std::vector<Gate> gates_at(const Gate& gate, double position) {
    std::vector<Gate> gates;
    for (const Interval& stretch : plane_.slice(gate.pinned_arm, position).intervals()) {
      const Slice slice = {gate.pinned_arm, position, stretch};
      const Gate there = gate_on(slice, gate.runs_up);
      if (leads_on(plane_, there) && obstacle_.side_of(slice, gate.runs_up) == side_) gates.push_back(there);
    }
    return gates;
  }

  const ForbiddenPlane& plane_;
  const Travellers& travellers_;
  Obstacle& obstacle_;
  int side_;
  const Budget& budget_;
  std::optional<Way> best_;
};

}  // namespace

std::optional<Way> slowest_gate(const ForbiddenPlane& plane, const Travellers& travellers, Obstacle& obstacle, int side,
                                const std::vector<Way>& near_by, const Budget& budget) {
  return SideSearch(plane, travellers, obstacle, side, budget).run(near_by);
}

}  // namespace dualarm
