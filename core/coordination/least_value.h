#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "geometry/interval.h"

namespace dualarm {

/// A position and the value of a function there; infinite where it is not defined.
struct Looked {
  double position = 0.0;
  double value = 0.0;
};

/// What is known of a function with one minimum, smooth or a corner, and two guesses at the rest: the parabola through
/// the lowest point and its neighbours, and, in each gap between points, the lines through the next two points on
/// either side, below which a convex function does not fall. The guess that told the last value better is trusted; the
/// search ends when it was right on both sides of the lowest point.
class LeastValueSearch {
 public:
  /// Three positions, ascending or descending.
  explicit LeastValueSearch(const std::array<Looked, 3>& known);

  double least() const { return points_[lowest()].value; }

  /// Where to look next.
  double next() const;

  /// What was found there. False if that is the end of the search: no more than `enough` is promised, and the last
  /// looks on both sides of the lowest point brought no news; or positions cannot tell any more.
  bool add(Looked looked, double enough);

 private:
  /// The least value that a guess promises, and where; or its value at a position.
  struct Guess {
    double position = 0.0;
    double value = std::numeric_limits<double>::infinity();
  };

  std::size_t lowest() const;
  bool is_finite(std::size_t index) const { return index < points_.size() && std::isfinite(points_[index].value); }
  double slope(std::size_t left) const;
  double line(std::size_t left, double position) const;
  Guess of_parabola(std::optional<double> position) const;
  Guess of_gap(std::size_t left, std::optional<double> position) const;
  Guess of_lines() const;
  Guess guess() const;
  std::size_t gap_of(double position) const;
  std::optional<double> beside_lowest(bool is_below) const;
  bool is_closed(std::size_t left) const;

  std::vector<Looked> points_;
  bool trusts_parabola_ = true;
  int looks_beside_ = 0;  ///< to be taken before the search ends: first above the lowest point, then below
};

/// Least value of a function with one minimum between three known positions, ends included: to `enough`, or to what
/// positions can tell. The minimum is often a corner, where interpolating methods stop at half the digits, or the end
/// of where the function is defined. Theory, section 3.
template <class Function>
double least_value(const Function& function, const std::array<Looked, 3>& known, double enough) {
  constexpr int kMostSteps = 100;
  LeastValueSearch search(known);
  for (int i = 0; i < kMostSteps; ++i) {
    const double position = search.next();
    if (!search.add({position, function(position)}, enough)) break;
  }
  return search.least();
}

}  // namespace dualarm
