#pragma once

#include <cmath>
#include <optional>

#include "geometry/interval.h"

namespace dualarm {

/// A value of a function, and how fast it grows.
struct Rated {
  double position = 0.0;
  double value = 0.0;
  double slope = 0.0;
};

/// What a climb gives up on, and begins with.
struct ClimbRules {
  double first_step = 0.0;  ///< of a climb from a point inside, in units of the position
  double same = 0.0;        ///< positions this close are one
  double part = 0.0;        ///< part of the value that is not worth a step
  double least = 0.0;       ///< value that is not worth a step either
};

/// A bracket of a maximum, with what is known at its ends.
struct Climb {
  Interval bracket;
  std::optional<Rated> left;   ///< rising at the lower end
  std::optional<Rated> right;  ///< falling at the upper end

  /// What the tangents promise beyond the better end, at most, where they meet; infinite where they do not.
  double promised() const;
  /// The next position to look at, `step` from the only known end, or where tangents meet, or where the slope falls to
  /// zero, at least `same` inside.
  double next(double step, bool at_tangents, double same) const;
};

/// Seeks the largest value of a function with one maximum, smooth or a corner, inside a bracket, by its slopes: where
/// the tangents from both sides meet, which leads to a corner, and where that gains little, where the slope falls to
/// zero, which leads to a smooth maximum. `rate` (position -> std::optional<Rated>) answers nothing where the function
/// is not defined: there the bracket ends. False if there is no slope somewhere: the climb ends there. The caller
/// remembers the best; `from` is where it begins.
template <class Rate>
bool climb(const Rate& rate, Interval bracket, const std::optional<Rated>& from, const ClimbRules& rules) {
  constexpr int kMostSteps = 40;
  constexpr double kStepGrowth = 8.0;
  constexpr double kGood = 0.2;  // part of the bracket that a good step leaves
  Climb climb = {bracket, std::nullopt, std::nullopt};
  std::optional<Rated> now = from;
  double step = rules.first_step;
  bool at_tangents = true;
  for (int i = 0; i < kMostSteps; ++i) {
    if (now) {
      if (!std::isfinite(now->slope)) return false;
      if (now->slope == 0.0) return true;
      (now->slope > 0.0 ? climb.left : climb.right) = now;
      (now->slope > 0.0 ? climb.bracket.lower : climb.bracket.upper) = now->position;
    } else if (!climb.left && !climb.right) {
      return false;
    }
    const double before = climb.bracket.length();
    const bool is_closed = climb.left && climb.right;
    if (before <= rules.same || (is_closed && climb.promised() <= rules.part * climb.left->value + rules.least))
      return true;
    const double position = climb.next(step, at_tangents, rules.same);
    now = rate(position);
    if (!now) (climb.left ? climb.bracket.upper : climb.bracket.lower) = position;
    if (!is_closed) {
      step *= kStepGrowth;
    } else if (now) {
      const double left_over = now->slope > 0.0 ? climb.bracket.upper - position : position - climb.bracket.lower;
      at_tangents = !at_tangents || left_over <= kGood * before;
    }
  }
  return true;
}

}  // namespace dualarm
