#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace dualarm {

/// The integral of a smooth function from the lower end of an interval on, as a Chebyshev series: for those who ask
/// for it at many places. Theory, section 1.1.
class IntegralSeries {
 public:
  /// Nothing if the function is not smooth enough for a fixed number of terms to tell its integral to rounding.
  template <class Function>
  static std::optional<IntegralSeries> of(const Function& function, double lower, double upper) {
    std::array<double, kTerms> values;
    for (std::size_t i = 0; i < kTerms; ++i) {
      values[i] = function(0.5 * (lower + upper) + 0.5 * (upper - lower) * node(i));
    }
    return from_values(values, lower, upper);
  }

  /// From the lower end to a place of the interval.
  double up_to(double place) const;

 private:
  static constexpr std::size_t kTerms = 28;

  IntegralSeries(double lower, double upper) : lower_(lower), half_(0.5 * (upper - lower)) {}

  static double node(std::size_t index);
  static std::optional<IntegralSeries> from_values(const std::array<double, kTerms>& values, double lower,
                                                   double upper);

  double lower_;
  double half_;
  std::size_t count_ = kTerms;                 ///< of coefficients that show
  std::array<double, kTerms> coefficients_{};  ///< of the Chebyshev polynomials over the interval
};

}  // namespace dualarm
