#include "tests/core/phase_plane/rig.h"

#include <algorithm>

namespace dualarm {

std::optional<double> braked_to_rest(const System& system, JointState from) {
  const double way = from.velocity < 0.0 || (from.velocity == 0.0 && std::signbit(from.velocity)) ? -1.0 : 1.0;
  const Extreme extreme = way > 0.0 ? Extreme::kLowest : Extreme::kHighest;
  const double limit = way > 0.0 ? system.velocity().upper : -system.velocity().lower;
  const double end = way > 0.0 ? system.range().upper : -system.range().lower;
  const auto rate = [&](double x, double v) { return way * system.extreme_acceleration(extreme, way * x, way * v); };
  double x = way * from.position;
  double v = way * from.velocity;
  for (int i = 0; i < 2'000'000; ++i) {
    const double a = rate(x, v);
    if (v <= 0.0 && a <= 0.0) return way * x;
    if (x > end + 1e-12 || v > limit * (1.0 + 1e-12)) return std::nullopt;
    const double scale = std::min(1.0, (0.01 + v) / std::max(std::abs(a), 1e-3));
    const double h = scale / 2000.0;
    const double v2 = v + 0.5 * h * a;
    const double a2 = rate(x + 0.5 * h * v, v2);
    const double v3 = v + 0.5 * h * a2;
    const double a3 = rate(x + 0.5 * h * v2, v3);
    const double v4 = v + h * a3;
    const double a4 = rate(x + h * v3, v4);
    const double next = v + h / 6.0 * (a + 2.0 * a2 + 2.0 * a3 + a4);
    if (next <= 0.0 && a < 0.0)
      return x - 0.5 * v * v / a <= end + 1e-12 ? std::optional(way * (x - 0.5 * v * v / a)) : std::nullopt;
    x += h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
    v = next;
  }
  return way * x;  // it creeps towards a standstill
}

}  // namespace dualarm
