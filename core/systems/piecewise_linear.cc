#include "core/systems/piecewise_linear.h"

#include <algorithm>
#include <cmath>

namespace dualarm {

PiecewiseLinear::PiecewiseLinear(double constant) : pieces_(1) { pieces_.front().value = constant; }

PiecewiseLinear::PiecewiseLinear(const std::vector<double>& knots, const std::vector<double>& values) {
  LinearPiece piece;
  piece.value = values.front();
  if (knots.size() > 1) {
    pieces_.reserve(knots.size() + 1);
    piece.anchor = piece.to = knots.front();
    pieces_.push_back(piece);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      const double slope = (values[i + 1] - values[i]) / (knots[i + 1] - knots[i]);
      pieces_.push_back({knots[i], knots[i + 1], knots[i], values[i], slope});
    }
    piece = {.from = knots.back(), .anchor = knots.back(), .value = values.back()};
  }
  pieces_.push_back(piece);
}

std::vector<double> PiecewiseLinear::bends(Interval within) const {
  std::vector<double> borders;
  for (std::size_t i = 1; i < pieces_.size(); ++i) {
    if (within.contains(pieces_[i].from)) borders.push_back(pieces_[i].from);
  }
  return borders;
}

double PiecewiseLinear::steepest_fall() const {
  double steepest = 0.0;
  for (const LinearPiece& piece : pieces_) steepest = std::max(steepest, -piece.slope);
  return steepest;
}

double PiecewiseLinear::integral_over_pieces(double from, double change) const {
  const auto begins_after = [](double s, const LinearPiece& piece) { return s < piece.from; };
  auto piece = std::upper_bound(pieces_.begin(), pieces_.end(), from, begins_after) - 1;
  double sum = 0.0;
  double rest = change;  // counted down, because `from + change` has lost the digits of a small change
  while (true) {
    const double to_border = (rest > 0.0 ? piece->to : piece->from) - from;
    const bool is_last = std::abs(rest) <= std::abs(to_border);
    const double step = is_last ? rest : to_border;
    sum += step * (piece->at(from) + 0.5 * piece->slope * step);
    if (is_last) return sum;
    rest -= step;
    from = rest > 0.0 ? piece->to : piece->from;
    piece += rest > 0.0 ? 1 : -1;
  }
}

}  // namespace dualarm
