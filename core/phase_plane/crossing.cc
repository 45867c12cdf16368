#include "core/phase_plane/crossing.h"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace dualarm {

double crossing(const std::function<double(double)>& function, double from, double to) {
  const double at_from = function(from);
  const double at_to = function(to);
  if (at_from == 0.0) return from;
  if (at_to == 0.0) return to;
  const double secant = from - at_from * (to - from) / (at_to - at_from);
  const double tiny = 4e-16 * (std::abs(at_from) + std::abs(at_to));
  if ((from - secant) * (secant - to) > 0.0 && std::abs(function(secant)) <= tiny) return secant;
  if (from > to) return crossing(function, to, from);
  std::uintmax_t iterations = 100;
  const auto [low, high] = boost::math::tools::toms748_solve(function, from, to, at_from, at_to,
                                                             boost::math::tools::eps_tolerance<double>(52), iterations);
  return 0.5 * (low + high);
}

}  // namespace dualarm
