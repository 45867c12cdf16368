#include "core/passage/passage_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/coordination/diagram.h"
#include "core/passage/detour.h"
#include "core/passage/extremal_pair.h"
#include "core/passage/sampled_delays.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// A plan this close to what no plan falls below, relative, needs no improvement.
constexpr double kGoodEnough = 1e-7;
/// Times (s) this close are one. No body moves as far as a part of the planning margin in it.
constexpr double kSameTime = 1e-9;
/// Detours (rad) that are tried on a grid first; then the pattern search's steps, by sampled delays and by exact ones.
constexpr std::array<double, 6> kGrid = {0.0, 0.03, 0.1, 0.2, 0.4, 0.8};
constexpr double kFirstStep = 0.05;
constexpr double kLastStep = 2e-4;
constexpr double kFirstExactStep = 5e-4;
constexpr double kLastExactStep = 2e-5;
constexpr double kShrink = 0.4;
/// Safe windows that sampled delays close, as a part of the duration: wider ones where the windows found turn out to be
/// none.
constexpr std::array<double, 3> kClosed = {2e-3, 8e-3, 3e-2};
/// Pairs of motions that are tried at most, by sampled delays and by exact ones.
constexpr int kMostSampled = 400;
constexpr int kMostExact = 14;

/// How far (rad) each arm goes beyond where it has to.
struct Pair {
  double early = 0.0;
  double late = 0.0;
};

/// The start times with waits that are none left out, and both arms ending together where they nearly do: knots that
/// are meant to share a time have to.
StartTimes snapped(StartTimes times, const Profile& first, const Profile& second) {
  if (times.first < kSameTime) times.first = 0.0;
  if (times.second < kSameTime) times.second = 0.0;
  const double later = times.first + first.duration() - times.second - second.duration();
  if (std::abs(later) < kSameTime && times.first > 0.0) times.first -= later;
  if (std::abs(later) < kSameTime && times.second > 0.0) times.second += later;
  times.duration = std::max(times.first + first.duration(), times.second + second.duration());
  return times;
}

/// The best start times with delays that are free of `forbidden` ones.
std::optional<StartTimes> best_times(const Profile& first, const Profile& second, const IntervalSet& forbidden,
                                     double max_delay) {
  const Timing first_timing = timing_of(first);
  const Timing second_timing = timing_of(second);
  const Interval possible = possible_delays(first_timing, second_timing);
  if (possible.empty()) return std::nullopt;
  const auto times = best_start_times(forbidden.complement(possible), first_timing, second_timing, max_delay);
  return times ? std::optional(snapped(*times, first, second)) : std::nullopt;
}

class PairSearch {
 public:
  PairSearch(const ForbiddenSet& forbidden, const Travellers& travellers, const Way& way, double least, double known,
             double max_delay, const Budget& budget)
      : forbidden_(forbidden),
        early_arm_(way.bound.early_arm),
        early_(travellers[early_arm_], position_of(way.gate, early_arm_), Hurry::kEarlyArrival),
        late_(travellers[1 - early_arm_], position_of(way.gate, 1 - early_arm_), Hurry::kLateDeparture),
        early_detours_(travellers[early_arm_], position_of(way.gate, early_arm_), Hurry::kEarlyArrival),
        late_detours_(travellers[1 - early_arm_], position_of(way.gate, 1 - early_arm_), Hurry::kLateDeparture),
        least_(std::max(least, way.bound.duration)),
        duration_(known),
        max_delay_(max_delay),
        budget_(budget) {}

  std::optional<PassagePlan> run() {
    if (!early_.exists() || !late_.exists()) return std::nullopt;
    const auto early = early_.motion(early_.within(least_));
    const auto late = late_.motion(late_.within(least_));
    if (early && late) exact_duration(*early, *late);
    if (is_done(exact_, kMostExact)) return best_;
    const Pair extremal = {early ? early_detours_.of(*early) : 0.0, late ? late_detours_.of(*late) : 0.0};
    for (const double closed : kClosed) {
      closed_ = closed;
      sampled_ = exact_ = 0;
      seek(extremal);
      if (best_ || budget_.exhausted()) break;
    }
    return best_;
  }

 private:
  bool is_done(int tries, int most) const {
    return duration_ <= least_ * (1.0 + kGoodEnough) || tries >= most || budget_.exhausted();
  }

  /// The duration of the pair after its best delay; infinite if there is none.
  double duration_of(Pair pair, bool exactly) {
    const auto early = early_detours_.motion(pair.early);
    const auto late = late_detours_.motion(pair.late);
    if (!early || !late) return kInfinity;
    return exactly ? exact_duration(*early, *late) : sampled_duration(*early, *late);
  }

  double sampled_duration(const Profile& early, const Profile& late) {
    ++sampled_;
    const Profile& first = early_arm_ == 0 ? early : late;
    const Profile& second = early_arm_ == 0 ? late : early;
    SampledDelays delays(forbidden_, first, second, closed_);
    const auto rough = best_times(first, second, delays.forbidden(), max_delay_);
    if (!rough) return kInfinity;
    delays.sharpen_near(rough->second - rough->first);
    const auto times = best_times(first, second, delays.forbidden(), max_delay_);
    return times ? times->duration : kInfinity;
  }

  double exact_duration(const Profile& early, const Profile& late) {
    ++exact_;
    const Profile& first = early_arm_ == 0 ? early : late;
    const Profile& second = early_arm_ == 0 ? late : early;
    const auto delays = forbidden_delays(forbidden_, first, second, budget_);
    if (!delays) return kInfinity;
    const auto times = best_times(first, second, *delays, max_delay_);
    if (!times) return kInfinity;
    if (times->duration < duration_) {
      duration_ = times->duration;
      best_ = PassagePlan{{first, second}, *times};
    }
    return times->duration;
  }

  /// By sampled delays from the best pair of a grid and from the extremal one, then by exact delays.
  void seek(Pair extremal) {
    Pair best = descend(best_on_grid(extremal), kFirstStep, kLastStep, false);
    const Pair other = descend(extremal, kFirstStep, kLastStep, false);
    if (duration_of(other, false) < duration_of(best, false)) best = other;
    descend(best, kFirstExactStep, kLastExactStep, true);
  }

  Pair best_on_grid(Pair from) {
    Pair best = from;
    double least = duration_of(from, false);
    for (const double early : kGrid) {
      for (const double late : kGrid) {
        if (is_done(sampled_, kMostSampled)) return best;
        const Pair pair = {early, late};
        const double duration = duration_of(pair, false);
        if (duration < least) {
          least = duration;
          best = pair;
        }
      }
    }
    return best;
  }

  /// Pattern search: to the best of the neighbours, closer ones where none is better.
  Pair descend(Pair from, double first_step, double last_step, bool exactly) {
    const auto done = [&] { return exactly ? is_done(exact_, kMostExact) : is_done(sampled_, kMostSampled); };
    double duration = duration_of(from, exactly);
    for (double step = first_step; step > last_step && !done();) {
      Pair next = from;
      double least = duration;
      for (const auto& [early, late] : {Pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, -1}, {-1, 1}, {-1, -1}, {1, 1}}) {
        const Pair beside = {std::max(0.0, from.early + step * early), std::max(0.0, from.late + step * late)};
        if (done() || (beside.early == from.early && beside.late == from.late)) continue;
        const double found = duration_of(beside, exactly);
        if (found < least) {
          least = found;
          next = beside;
        }
      }
      if (least < duration) {
        from = next;
        duration = least;
      } else {
        step *= kShrink;
      }
    }
    return from;
  }

  const ForbiddenSet& forbidden_;
  int early_arm_;
  Through early_;
  Through late_;
  Detours early_detours_;
  Detours late_detours_;
  double least_;
  double duration_;  ///< s, of the best plan known
  double max_delay_;
  const Budget& budget_;
  std::optional<PassagePlan> best_;
  double closed_ = kClosed.front();
  int sampled_ = 0;
  int exact_ = 0;
};

}  // namespace

std::optional<PassagePlan> extremal_plan(const Travellers& travellers, const Way& way, double least, double max_delay) {
  const double duration = std::max(least, way.bound.duration);
  const bool is_known = way.pair && way.pair->duration == duration;
  const auto pair = is_known ? way.pair : extremal_pair(travellers, way.gate, way.bound, duration);
  if (!pair) return std::nullopt;
  const int early_arm = pair->early_arm;
  const Profile& first = early_arm == 0 ? pair->early : pair->late;
  const Profile& second = early_arm == 0 ? pair->late : pair->early;
  const Timing first_timing = timing_of(first);
  const Timing second_timing = timing_of(second);
  const Interval possible = possible_delays(first_timing, second_timing);
  const double wait = pair->wait();
  const double wanted = early_arm == 0 ? wait : -wait;
  const double delay = std::min(std::max(wanted, possible.lower), possible.upper);
  if (std::abs(delay - wanted) > kSameTime) return std::nullopt;
  const auto times = best_start_times(IntervalSet({{delay, delay}}), first_timing, second_timing, max_delay);
  if (!times) return std::nullopt;
  return PassagePlan{{first, second}, snapped(*times, first, second)};
}

std::optional<PassagePlan> passage_plan(const ForbiddenSet& forbidden, const Travellers& travellers, const Way& way,
                                        double least, double known, double max_delay, const Budget& budget) {
  return PairSearch(forbidden, travellers, way, least, known, max_delay, budget).run();
}

}  // namespace dualarm
