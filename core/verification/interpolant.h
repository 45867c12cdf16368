#pragma once

#include <array>
#include <vector>

#include "core/model/trajectory.h"
#include "geometry/interval.h"

namespace dualarm {

/// Whether two knots, in order of time, tell one state twice and have no motion between them.
bool share_a_time(const Knot& before, const Knot& after);

/// The motion between two knots: the polynomial of degree five with the position, velocity and acceleration of both.
class Quintic {
 public:
  /// Precondition: start.time < end.time.
  Quintic(const Knot& start, const Knot& end);

  Interval time() const { return {start_, start_ + duration_}; }
  double duration() const { return duration_; }

  /// Derivative with respect to time of an order from 0 to 5 (rad/s^order) at a time (s), clamped to the piece.
  double derivative(int order, double time) const;

  /// All derivatives of order 0 to 5 (rad/s^order) in the middle of the piece.
  std::array<double, 6> in_the_middle() const;

  /// An interval that contains a derivative of order 0 to 3 (rad/s^order) over the whole piece: its chord, and what the
  /// second derivative of that can make of it.
  Interval range(int order) const;

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

/// One arm's motion as it is sent: quintics one after the other, none where two knots share a time. Outside of its
/// time it stays at its ends.
class Interpolant {
 public:
  /// Precondition: at least one knot; numbers finite, times not decreasing.
  explicit Interpolant(const std::vector<Knot>& knots);

  const std::vector<Quintic>& pieces() const { return pieces_; }
  JointState state(double time) const;

  /// Upper bound (rad) on the way the joint goes, to and fro, during an interval of time.
  double travel(Interval time) const;

  /// Upper bounds on speed (rad/s) and acceleration (rad/s2) during an interval of time.
  struct Bounds {
    double speed = 0.0;
    double acceleration = 0.0;
  };
  Bounds bounds(Interval time) const;

 private:
  /// What a number of pieces one after the other have together, so that long motions are bounded quickly.
  struct Block {
    double travel = 0.0;
    Bounds most;
  };

  std::size_t piece_at(double time) const;
  void summarise();

  /// Calls visit_piece or visit_block for all that begins before the end of an interval of time.
  template <typename VisitPiece, typename VisitBlock>
  void walk(Interval time, VisitPiece visit_piece, VisitBlock visit_block) const;

  JointState start_;
  JointState end_;
  std::vector<Quintic> pieces_;
  std::vector<Block> blocks_;
};

}  // namespace dualarm
