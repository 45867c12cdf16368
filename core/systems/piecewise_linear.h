#pragma once

#include <limits>
#include <vector>

#include "core/model/torque_limit.h"

namespace dualarm {

/// A line over a stretch: value + slope * (s - anchor) for s in [from, to].
struct LinearPiece {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  double anchor = 0.0;
  double value = 0.0;  ///< at the anchor
  double slope = 0.0;

  double at(double s) const { return value + slope * (s - anchor); }
};

/// A continuous function of one variable, linear between knots and constant outside them: an end of a torque limit over
/// the positions, at one velocity.
class PiecewiseLinear {
 public:
  /// The same everywhere.
  explicit PiecewiseLinear(double constant);

  /// Precondition: knots strictly increasing, at least one, and as many values.
  PiecewiseLinear(const std::vector<double>& knots, const std::vector<double>& values);

  /// Adds a number everywhere.
  void add(double change) {
    for (LinearPiece& piece : pieces_) piece.value += change;
  }

  bool is_constant() const { return pieces_.size() == 1; }

  /// Pieces from minus to plus infinity, each ending where the next begins; at a border the later one counts.
  const std::vector<LinearPiece>& pieces() const { return pieces_; }

  /// The pieces' borders in `within`, ascending.
  std::vector<double> bends(Interval within) const;

  /// Integral from `from` to `from + change`, to the rounding of its summands. Linear in the number of pieces crossed.
  double integral(double from, double change) const {
    return is_constant() ? pieces_.front().value * change : integral_over_pieces(from, change);
  }

  /// The largest -slope of any piece; 0 if none falls.
  double steepest_fall() const;

 private:
  double integral_over_pieces(double from, double change) const;

  std::vector<LinearPiece> pieces_;
};

}  // namespace dualarm
