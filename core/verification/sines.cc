#include "core/verification/sines.h"

#include <algorithm>
#include <cmath>

#include "core/verification/pair.h"

namespace dualarm {
namespace {

/// Angles that share a call.
constexpr std::size_t kGroup = 16;

/// rad. The first terms that are left out of the series below, x^13 / 13! and x^14 / 14!, are less than 3e-18 up to
/// here. Rounding adds some 5e-16: half a last digit of 1 in each of the two products and their sum, less in the
/// series.
constexpr double kMostDifference = 0.25;

/// Sine of a small angle, and how much its cosine is less than 1 (with a minus sign).
template <typename Number>
struct SmallAngle {
  Number sine;
  Number cosine_less_one;

  explicit SmallAngle(Number x) {
    const Number y = x * x;
    sine =
        x +
        x * y * (-1.0 / 6.0 + y * (1.0 / 120.0 + y * (-1.0 / 5040.0 + y * (1.0 / 362880.0 + y * (-1.0 / 39916800.0)))));
    cosine_less_one =
        y * (-0.5 + y * (1.0 / 24.0 +
                         y * (-1.0 / 720.0 + y * (1.0 / 40320.0 + y * (-1.0 / 3628800.0 + y * (1.0 / 479001600.0))))));
  }
};

}  // namespace

Eigen::ArrayX2d sines_and_cosines(std::span<const double> angles) {
  Eigen::ArrayX2d result(static_cast<Eigen::Index>(angles.size()), 2);
  for (std::size_t first = 0; first < angles.size(); first += kGroup) {
    const std::size_t count = std::min(kGroup, angles.size() - first);
    const double* const angle = angles.data() + first;
    double* const sine = result.col(0).data() + first;
    double* const cosine = result.col(1).data() + first;
    const double middle = angle[count / 2];
    const auto [least, most] = std::minmax_element(angle, angle + count);
    if (!(*most - middle <= kMostDifference && middle - *least <= kMostDifference)) {
      std::transform(angle, angle + count, sine, [](double x) { return std::sin(x); });
      std::transform(angle, angle + count, cosine, [](double x) { return std::cos(x); });
      continue;
    }
    const double s = std::sin(middle);
    const double c = std::cos(middle);
    for_pairs(count, [=](auto number, std::size_t i) {
      const SmallAngle difference(load<decltype(number)>(angle + i) - middle);
      store(sine + i, s + (c * difference.sine + s * difference.cosine_less_one));
      store(cosine + i, c + (c * difference.cosine_less_one - s * difference.sine));
    });
  }
  return result;
}

}  // namespace dualarm
