#include "core/verification/sines.h"

#include <algorithm>
#include <cmath>

#include "core/verification/lanes.h"

namespace dualarm {
namespace {

/// Angles that share a call.
constexpr std::size_t kGroup = 32;

/// rad. The first terms that are left out of the series below, x^13 / 13! and x^14 / 14!, are less than 3e-18 up to
/// here. Rounding adds some 5e-16: half a last digit of 1 in each of the two products and their sum, less in the
/// series.
constexpr double kMostDifference = 0.25;

/// Sine of a small angle, and how much its cosine is less than 1 (with a minus sign).
template <typename Number>
struct SmallAngle {
  Number sine;
  Number cosine_less_one;

  [[gnu::always_inline]] explicit SmallAngle(const Number& x) {
    const Number y = x * x;
    sine =
        x +
        x * y * (-1.0 / 6.0 + y * (1.0 / 120.0 + y * (-1.0 / 5040.0 + y * (1.0 / 362880.0 + y * (-1.0 / 39916800.0)))));
    cosine_less_one =
        y * (-0.5 + y * (1.0 / 24.0 +
                         y * (-1.0 / 720.0 + y * (1.0 / 40320.0 + y * (-1.0 / 3628800.0 + y * (1.0 / 479001600.0))))));
  }
};

/// Sines and cosines of neighbours from those of a middle one; false, and nothing, where they differ by too much.
bool add_differences(const double* angle, std::size_t count, double middle, double* sine, double* cosine) {
  Lanes farthest = Lanes();
  gather_lanes(
      count, farthest, [=]<typename Number>(std::size_t i, Lanes & so_far) __attribute__((always_inline)) {
        so_far = greater<Lanes>(so_far, widened(magnitude<Number>(load<Number>(angle + i) - middle)));
      });
  if (!(most_of(farthest) <= kMostDifference)) return false;
  const double s = std::sin(middle);
  const double c = std::cos(middle);
  for_lanes(
      count, [=]<typename Number>(std::size_t i) __attribute__((always_inline)) {
        const SmallAngle<Number> difference(load<Number>(angle + i) - middle);
        store<Number>(sine + i, s + (c * difference.sine + s * difference.cosine_less_one));
        store<Number>(cosine + i, c + (c * difference.cosine_less_one - s * difference.sine));
      });
  return true;
}

}  // namespace

Eigen::ArrayX2d sines_and_cosines(std::span<const double> angles) {
  Eigen::ArrayX2d result(static_cast<Eigen::Index>(angles.size()), 2);
  for (std::size_t first = 0; first < angles.size(); first += kGroup) {
    const std::size_t count = std::min(kGroup, angles.size() - first);
    const double* const angle = angles.data() + first;
    double* const sine = result.col(0).data() + first;
    double* const cosine = result.col(1).data() + first;
    if (add_differences(angle, count, angle[count / 2], sine, cosine)) continue;
    std::transform(angle, angle + count, sine, [](double x) { return std::sin(x); });
    std::transform(angle, angle + count, cosine, [](double x) { return std::cos(x); });
  }
  return result;
}

}  // namespace dualarm
