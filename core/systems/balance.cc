#include "core/systems/balance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/phase_plane/crossing.h"

namespace dualarm {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

Interval overlap(Interval a, Interval b) { return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)}; }

double surplus(const LinearPiece& piece, const GravityTorque& gravity, double s) {
  return piece.at(s) - gravity.amplitude * std::sin(s - gravity.phase);
}

/// Appends base + k * turn, for every whole k, as far as it lies in `within`.
void append_repeated(std::vector<double>& positions, double base, Interval within) {
  const double first = base + kTurn * std::ceil((within.lower - base) / kTurn);
  const int count = first <= within.upper ? 1 + static_cast<int>((within.upper - first) / kTurn) : 0;
  for (int k = 0; k < count; ++k) positions.push_back(std::clamp(first + k * kTurn, within.lower, within.upper));
}

/// Where in `within` the surplus along a piece has no slope, ascending.
std::vector<double> flat_points(const LinearPiece& piece, const GravityTorque& gravity, Interval within) {
  const double cosine = piece.slope / gravity.amplitude;
  std::vector<double> positions;
  if (!(std::abs(cosine) < 1.0)) return positions;
  const double angle = std::acos(cosine);
  append_repeated(positions, gravity.phase - angle, within);
  append_repeated(positions, gravity.phase + angle, within);
  std::sort(positions.begin(), positions.end());
  return positions;
}

/// The part of `within` in which a piece's torque is no larger than gravity's amplitude: sign changes lie in it.
Interval reach_of_gravity(const LinearPiece& piece, const GravityTorque& gravity, Interval within) {
  const double most = std::abs(gravity.amplitude);
  if (piece.slope == 0.0) return std::abs(piece.value) <= most ? within : Interval{0.0, -1.0};
  const double a = piece.anchor + (-most - piece.value) / piece.slope;
  const double b = piece.anchor + (most - piece.value) / piece.slope;
  return overlap(within, {std::min(a, b), std::max(a, b)});
}

/// Walks along positions between which the surplus changes sign once at most.
class SignWalk {
 public:
  /// To the next position with its surplus, along a piece.
  void step(double position, double here, const LinearPiece& piece, const GravityTorque& gravity) {
    if (here == 0.0) {
      if (!std::exchange(on_zero_, true)) zero_ = position;
      return;
    }
    const bool changes = here * sign() < 0.0;
    if (on_zero_ && (changes || before_ == 0.0)) {
      found_.push_back(zero_);
    } else if (changes) {
      // The ends' signs are settled: the next piece may see its first one otherwise by a rounding.
      const auto along = [&](double s) {
        return s == last_ ? before_ : s == position ? here : surplus(piece, gravity, s);
      };
      found_.push_back(crossing(along, last_, position));
    }
    on_zero_ = false;
    before_ = here;
    last_ = position;
  }

  std::vector<double> finish() {
    if (on_zero_ && before_ != 0.0) found_.push_back(zero_);
    return std::move(found_);
  }

 private:
  double sign() const { return before_ < 0.0 ? -1.0 : before_ > 0.0 ? 1.0 : 0.0; }  // products of surpluses underflow

  std::vector<double> found_;
  double last_ = 0.0;     ///< the last position with a surplus other than zero
  double before_ = 0.0;   ///< the surplus there; 0 before the first
  bool on_zero_ = false;  ///< the surplus is zero from zero_ up to here
  double zero_ = 0.0;
};

}  // namespace

double extreme_surplus(Extreme extreme, const PiecewiseLinear& torque, const GravityTorque& gravity, Interval within) {
  const double sign = extreme == Extreme::kHighest ? 1.0 : -1.0;
  double largest = -std::numeric_limits<double>::infinity();  // of sign * surplus
  for (const LinearPiece& piece : torque.pieces()) {
    const Interval here = overlap(within, {piece.from, piece.to});
    if (here.empty()) continue;
    const double line = std::max(sign * piece.at(here.lower), sign * piece.at(here.upper));
    if (line + std::abs(gravity.amplitude) <= largest) continue;
    const auto include = [&](double s) { largest = std::max(largest, sign * surplus(piece, gravity, s)); };
    const auto include_flats = [&](Interval over) {
      const std::vector<double> flats = flat_points(piece, gravity, over);
      std::for_each(flats.begin(), flats.end(), include);
    };
    include(here.lower);
    include(here.upper);
    // Turn by turn the surplus follows the line: it is largest in the first turn or in the last.
    include_flats(overlap(here, {here.lower, here.lower + kTurn}));
    if (here.length() > kTurn) include_flats({here.upper - kTurn, here.upper});
  }
  return sign * largest;
}

std::vector<double> balances(double torque, const GravityTorque& gravity, Interval within) {
  const double ratio = torque / gravity.amplitude;
  std::vector<double> positions;
  if (!(std::abs(ratio) < 1.0)) return positions;
  const double angle = std::asin(ratio);
  append_repeated(positions, gravity.phase + angle, within);
  append_repeated(positions, gravity.phase + std::numbers::pi - angle, within);
  std::sort(positions.begin(), positions.end());
  return positions;
}

std::vector<double> balances(const PiecewiseLinear& torque, const GravityTorque& gravity, Interval within) {
  const std::vector<LinearPiece>& pieces = torque.pieces();
  if (torque.is_constant()) return balances(pieces.front().value, gravity, within);
  SignWalk walk;
  bool is_first = true;
  for (auto piece = pieces.begin(); piece != pieces.end(); ++piece) {
    const Interval here = overlap(within, {piece->from, piece->to});
    if (!(here.lower < here.upper)) continue;
    const auto step_to = [&](double s) { walk.step(s, surplus(*piece, gravity, s), *piece, gravity); };
    if (std::exchange(is_first, false)) step_to(here.lower);
    const std::vector<double> flats = flat_points(*piece, gravity, reach_of_gravity(*piece, gravity, here));
    for (const double flat : flats) {
      if (here.lower < flat && flat < here.upper) step_to(flat);
    }
    // A border's torque is the one that the table names.
    const LinearPiece& beyond = here.upper == piece->to ? *(piece + 1) : *piece;
    walk.step(here.upper, surplus(beyond, gravity, here.upper), *piece, gravity);
  }
  return walk.finish();
}

}  // namespace dualarm
