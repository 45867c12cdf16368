#include "core/phase_plane/integral_series.h"

#include <algorithm>
#include <numbers>
#include <vector>

namespace dualarm {
namespace {

/// What the last coefficients of the function may be of its first one, and how many are looked at.
constexpr double kRounding = 3e-15;
constexpr std::size_t kLast = 4;
/// What a coefficient of the integral is of the first ones that does not show.
constexpr double kHidden = 1e-17;

/// cos(pi k (2 i + 1) / (2 n)) for all k and i: each row a Chebyshev polynomial at the nodes.
template <std::size_t kCount>
std::array<std::array<double, kCount>, kCount> polynomials_at_nodes() {
  std::array<std::array<double, kCount>, kCount> polynomials;
  for (std::size_t k = 0; k < kCount; ++k) {
    for (std::size_t i = 0; i < kCount; ++i) {
      const std::size_t quarters = k * (2 * i + 1) % (4 * kCount);
      polynomials[k][i] = std::cos(std::numbers::pi * static_cast<double>(quarters) / (2.0 * kCount));
    }
  }
  return polynomials;
}

template <std::size_t kCount>
const std::array<std::array<double, kCount>, kCount>& polynomials() {
  static const auto kPolynomials = polynomials_at_nodes<kCount>();
  return kPolynomials;
}

}  // namespace

double IntegralSeries::node(std::size_t index) { return polynomials<kTerms>()[1][index]; }

std::optional<IntegralSeries> IntegralSeries::from_values(const std::array<double, kTerms>& values, double lower,
                                                          double upper) {
  std::array<double, kTerms + 1> of_function{};
  for (std::size_t k = 0; k < kTerms; ++k) {
    const std::array<double, kTerms>& row = polynomials<kTerms>()[k];
    for (std::size_t i = 0; i < kTerms; ++i) of_function[k] += values[i] * row[i];
    of_function[k] *= 2.0 / kTerms;
  }
  double tail = 0.0;
  for (std::size_t k = kTerms - kLast; k < kTerms; ++k) tail += std::abs(of_function[k]);
  if (!(tail <= kRounding * std::abs(of_function[0]))) return std::nullopt;

  IntegralSeries series(lower, upper);
  std::array<double, kTerms>& integral = series.coefficients_;
  double at_lower = 0.0;
  for (std::size_t k = 1; k < kTerms; ++k) {
    integral[k] = series.half_ * (of_function[k - 1] - of_function[k + 1]) / static_cast<double>(2 * k);
    at_lower += k % 2 == 0 ? integral[k] : -integral[k];
  }
  integral[0] = -at_lower;
  while (series.count_ > 2 && std::abs(integral[series.count_ - 1]) <= kHidden * std::abs(integral[1])) {
    --series.count_;
  }
  return series;
}

double IntegralSeries::up_to(double place) const {
  const double x = std::clamp((place - lower_) / half_ - 1.0, -1.0, 1.0);
  // Clenshaw's recurrence waits for each term in turn; even and odd polynomials are recurrences in 2 x^2 - 1 of half
  // the length, and do not wait for each other.
  const double twice = 2.0 * (2.0 * x * x - 1.0);
  double even = 0.0;
  double even_before = 0.0;
  double odd = 0.0;
  double odd_before = 0.0;
  for (std::size_t k = (count_ - 1) / 2; k > 0; --k) {
    const double next_even = coefficients_[2 * k] + twice * even - even_before;
    const double next_odd = coefficients_[2 * k + 1] + twice * odd - odd_before;
    even_before = even;
    odd_before = odd;
    even = next_even;
    odd = next_odd;
  }
  return coefficients_[0] + 0.5 * twice * even - even_before +
         x * (coefficients_[1] + (twice - 1.0) * odd - odd_before);
}

}  // namespace dualarm
