#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "core/model/problem.h"
#include "geometry/interval.h"

namespace dualarm {

/// One of the two ends of an interval of admissible accelerations.
enum class Extreme { kLowest, kHighest };

/// The integral over s of an acceleration that is a constant less a sine, from a position on: what specific_work
/// answers, for those who ask it often.
struct SineWork {
  double constant = 0.0;  ///< rad/s2
  double sine = 0.0;      ///< rad/s2, of the sine, in the position
  double cosine = 0.0;    ///< rad/s2, its derivative there

  /// Over a change of s (rad), (rad/s)2. Keeps its digits for small change: the difference of two cosines as a product
  /// of sines.
  double over(double change) const {
    const double half_sine = std::sin(0.5 * change);
    const double half_cosine = std::cos(0.5 * change);
    return constant * change - 2.0 * half_sine * (sine * half_cosine + cosine * half_sine);
  }

  /// The acceleration (rad/s2) after a change of s (rad).
  double rate(double change) const { return constant - sine * std::cos(change) - cosine * std::sin(change); }
};

/// One degree of freedom with coordinate s (rad), as the phase plane sees it: over which s, which accelerations are
/// admissible, which velocities are. Knows nothing of robots; a single joint is one, an arm along a path can be.
///
/// What the algorithm assumes, and tests/core/systems/system_laws.h holds every System to:
/// - admissible accelerations at (s, s_dot) form an interval with lower < upper, continuous in both, smooth between
///   bends;
/// - where velocity_matters says no, an end is the same at every velocity of that direction, and specific_work is its
///   exact integral over s, so that 1/2 s_dot^2 changes by it along an extremal arc;
/// - zeros lists every sign change along s of an end at a constant velocity;
/// - velocity limits are constant, with lower < 0 < upper.
class System {
 public:
  virtual ~System() = default;

  /// Where s may be.
  virtual Interval range() const = 0;

  /// Lowest (negative) and highest (positive) admissible velocity, rad/s; may be infinite.
  virtual Interval velocity() const = 0;

  /// Lowest and highest admissible acceleration, rad/s2, at s with velocity s_dot (rad/s), which need not be
  /// admissible.
  virtual Interval acceleration(double s, double s_dot) const = 0;

  /// Bounds of `acceleration` over the whole range and all admissible velocities, rad/s2; may be infinite where
  /// velocities are.
  virtual Interval acceleration_bounds() const = 0;

  /// Bounds of `acceleration` over the whole range and some velocities (rad/s), rad/s2.
  virtual Interval acceleration_bounds(Interval velocities) const = 0;

  /// Whether an end of `acceleration` depends on the velocity while s moves in a direction (+1 or -1).
  virtual bool velocity_matters(Extreme extreme, double direction) const = 0;

  /// Whether moving in a direction (+1 or -1) leaves no more acceleration in that direction than standing still.
  virtual bool drives_best_at_rest(double direction) const = 0;

  /// Integral of an end of `acceleration` at standstill from `from` to `from + change`, (rad/s)2. Keeps its digits for
  /// small change.
  virtual double specific_work(Extreme extreme, double from, double change) const = 0;

  /// The same as a function of the change, where it is as simple as that.
  virtual std::optional<SineWork> work_from(Extreme /*extreme*/, double /*from*/) const { return std::nullopt; }

  /// Where in `within` an end of `acceleration` at the constant velocity s_dot changes sign, ascending.
  virtual std::vector<double> zeros(Extreme extreme, double s_dot, Interval within) const = 0;

  /// Where in `within` the accelerations have a bend as functions of s, ascending.
  virtual std::vector<double> position_bends(Interval within) const = 0;

  /// At which velocities the accelerations have a bend as functions of s_dot, ascending; standstill need not be listed.
  virtual std::vector<double> velocity_bends() const = 0;

  /// Fills in the coefficients of powers of time of the way (rad) from a state along an extremal arc, and says yes; or
  /// no, where accelerations have bends or no such series is known.
  virtual bool extremal_series(Extreme /*extreme*/, JointState /*from*/, std::span<double> /*way*/) const {
    return false;
  }

  /// The largest -d(acceleration)/ds of either end at standstill over all s, inside the range or not, 1/s2; >= 0.
  virtual double stiffness() const = 0;

  /// An end of the admissible accelerations, rad/s2.
  double extreme_acceleration(Extreme extreme, double s, double s_dot) const {
    const Interval admissible = acceleration(s, s_dot);
    return extreme == Extreme::kLowest ? admissible.lower : admissible.upper;
  }
};

}  // namespace dualarm
