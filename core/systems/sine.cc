#include "core/systems/sine.h"

#include <cmath>
#include <cstdint>

namespace dualarm {
namespace {

/// rad. Farther angles are left to the library: the quarter turns of this method have 33 bits, to be multiplied by 20.
constexpr double kFarthest = 1e6;

constexpr double kPerQuarter = 6.36619772367581382433e-01;   // 2 / pi
constexpr double kQuarterHead = 1.57079632673412561417e+00;  // pi / 2, its first 33 bits
constexpr double kQuarterTail = 6.07710050650619224932e-11;

/// Added and taken away again, leaves the nearest whole number.
constexpr double kRounder = 6755399441055744.0;  // 1.5 * 2^52

/// An angle as quarter turns and what is left, in two parts.
struct Reduced {
  std::int64_t quarters;
  double rest;
  double rest_tail;
};

Reduced reduced(double angle) {
  const double quarters = (angle * kPerQuarter + kRounder) - kRounder;
  const double head = angle - quarters * kQuarterHead;
  const double tail = quarters * kQuarterTail;
  const double rest = head - tail;
  return {static_cast<std::int64_t>(quarters), rest, (head - rest) - tail};
}

/// For angles within an eighth of a turn.
double sine_of_rest(const Reduced& at) {
  const double x = at.rest;
  const double z = x * x;
  const double higher =
      8.33333333332248946124e-03 +
      z * (-1.98412698298579493134e-04 +
           z * (2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
  const double cube = z * x;
  return x - ((z * (0.5 * at.rest_tail - cube * higher) - at.rest_tail) - cube * -1.66666666666666324348e-01);
}

double cosine_of_rest(const Reduced& at) {
  const double x = at.rest;
  const double z = x * x;
  const double higher = z * (4.16666666666666019037e-02 +
                             z * (-1.38888888888741095749e-03 +
                                  z * (2.48015872894767294178e-05 +
                                       z * (-2.75573143513906633035e-07 +
                                            z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
  const double half = 0.5 * z;
  const double most = 1.0 - half;
  return most + (((1.0 - most) - half) + (z * higher - x * at.rest_tail));
}

}  // namespace

double sine(double angle) {
  if (!(std::abs(angle) <= kFarthest)) return std::sin(angle);
  const Reduced at = reduced(angle);
  const double size = at.quarters % 2 == 0 ? sine_of_rest(at) : cosine_of_rest(at);
  return (at.quarters & 2) == 0 ? size : -size;
}

SineCosine sine_cosine(double angle) {
  if (!(std::abs(angle) <= kFarthest)) return {std::sin(angle), std::cos(angle)};
  const Reduced at = reduced(angle);
  const double of_sine = sine_of_rest(at);
  const double of_cosine = cosine_of_rest(at);
  switch (at.quarters & 3) {
    case 0:
      return {of_sine, of_cosine};
    case 1:
      return {of_cosine, -of_sine};
    case 2:
      return {-of_sine, -of_cosine};
    default:
      return {-of_cosine, of_sine};
  }
}

}  // namespace dualarm
