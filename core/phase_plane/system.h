#pragma once

#include <vector>

#include "geometry/interval.h"

namespace dualarm {

/// One of the two ends of an interval of admissible accelerations.
enum class Extreme { kLowest, kHighest };

/// One degree of freedom with coordinate s (rad), as the phase plane sees it: over which s, which accelerations are
/// admissible, which velocities are. Knows nothing of robots; a single joint is one, an arm along a path can be.
///
/// What the algorithm assumes, and tests/core/systems/system_laws.h holds every System to:
/// - admissible accelerations at s form an interval with lower < upper that does not depend on the velocity;
/// - specific_work is the exact integral of their ends, so that 1/2 s_dot^2 changes by it along an extremal arc;
/// - zeros lists every sign change of an end, so that between two of them 1/2 s_dot^2 is monotone along an arc;
/// - velocity limits are constant, with lower < 0 < upper.
class System {
 public:
  virtual ~System() = default;

  /// Where s may be.
  virtual Interval range() const = 0;

  /// Lowest and highest admissible acceleration at s, rad/s2.
  virtual Interval acceleration(double s) const = 0;

  /// Bounds of `acceleration` over the whole range, rad/s2.
  virtual Interval acceleration_bounds() const = 0;

  /// Lowest (negative) and highest (positive) admissible velocity, rad/s; may be infinite.
  virtual Interval velocity() const = 0;

  /// Integral of an end of `acceleration` from `from` to `from + change`, (rad/s)2. Keeps its digits for small change.
  virtual double specific_work(Extreme extreme, double from, double change) const = 0;

  /// Where in `within` an end of `acceleration` changes sign, ascending.
  virtual std::vector<double> zeros(Extreme extreme, Interval within) const = 0;

  /// An end of the admissible accelerations at s, rad/s2.
  double extreme_acceleration(Extreme extreme, double s) const {
    const Interval admissible = acceleration(s);
    return extreme == Extreme::kLowest ? admissible.lower : admissible.upper;
  }
};

}  // namespace dualarm
