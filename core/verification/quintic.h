#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "core/model/trajectory.h"
#include "core/verification/tolerances.h"
#include "geometry/interval.h"

namespace dualarm {

/// s: knots up to a time (s) that share one are no farther apart.
inline double longest_shared(double time) {
  return std::max(kSameTime, kSameTimeDigits * std::numeric_limits<double>::epsilon() * time);
}

/// Whether two knots, in order of time, tell one state twice and have no motion between them.
inline bool share_a_time(double before, double after) { return after - before <= longest_shared(after); }
inline bool share_a_time(const Knot& before, const Knot& after) { return share_a_time(before.time, after.time); }

/// The motion between two knots: the polynomial of degree five with the position, velocity and acceleration of both.
class Quintic {
 public:
  /// Precondition: start.time < end.time.
  Quintic(const Knot& start, const Knot& end);

  /// State of it at a time (s), clamped to the piece: what a Quintic is not worth being made for.
  static JointState state(const Knot& start, const Knot& end, double time);

  Interval time() const { return {start_, start_ + duration_}; }
  double duration() const { return duration_; }

  /// Derivative with respect to time of an order from 0 to 5 (rad/s^order) at a time (s), clamped to the piece.
  double derivative(int order, double time) const;

  /// All derivatives of order 0 to 5 (rad/s^order) in the middle of the piece.
  std::array<double, 6> in_the_middle() const;

  /// Upper bound on the magnitude of a derivative, order 1 to 5, over the whole piece.
  double most(int order) const { return most_[order]; }

  /// How much the last digits of the knots may matter, rad/s and rad/s2: a quintic over a short time magnifies the
  /// rounding of its ends. Motions that differ by less have the same knots.
  double velocity_rounding() const { return velocity_rounding_; }
  double acceleration_rounding() const { return acceleration_rounding_; }

 private:
  double start_;
  double duration_;
  std::array<double, 6> coefficients_;  // of powers of (time - start) / duration, rad
  std::array<double, 6> most_;
  double velocity_rounding_;
  double acceleration_rounding_;
};

}  // namespace dualarm
