#include "clients/cpp/motion_curve.h"

#include <algorithm>
#include <limits>

namespace dualarm {
namespace {

using planning::v1::Knots;

bool has_equal_columns(const Knots& knots) {
  const int size = knots.time_s_size();
  return size > 0 && knots.position_rad_size() == size && knots.velocity_rad_per_s_size() == size &&
         knots.acceleration_rad_per_s2_size() == size;
}

// Hermite's quintic over [0, h] at the fraction u of it, from the two end states.
double quintic(const Knots& knots, int left, double u) {
  const int right = left + 1;
  const double h = knots.time_s(right) - knots.time_s(left);
  const double p0 = knots.position_rad(left);
  const double v0 = knots.velocity_rad_per_s(left) * h;
  const double a0 = knots.acceleration_rad_per_s2(left) * h * h;
  const double v1 = knots.velocity_rad_per_s(right) * h;
  const double a1 = knots.acceleration_rad_per_s2(right) * h * h;
  const double step = knots.position_rad(right) - p0;
  const double c3 = 10.0 * step - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1;
  const double c4 = -15.0 * step + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1;
  const double c5 = 6.0 * step - 3.0 * (v0 + v1) - 0.5 * (a0 - a1);
  return p0 + u * (v0 + u * (0.5 * a0 + u * (c3 + u * (c4 + u * c5))));
}

}  // namespace

double position_at(const Knots& knots, double time_s) {
  if (!has_equal_columns(knots)) return std::numeric_limits<double>::quiet_NaN();
  const auto& times = knots.time_s();
  const auto after = std::upper_bound(times.begin(), times.end(), time_s);
  if (after == times.begin()) return knots.position_rad(0);
  if (after == times.end()) return knots.position_rad(knots.position_rad_size() - 1);
  const int left = static_cast<int>(after - times.begin()) - 1;
  return quintic(knots, left, (time_s - times[left]) / (times[left + 1] - times[left]));
}

std::vector<PathPoint> path_of(const Knots& first, const Knots& second, double duration_s, int count) {
  std::vector<PathPoint> path;
  path.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    const double time = duration_s * k / (count - 1);
    path.push_back({time, position_at(first, time), position_at(second, time)});
  }
  return path;
}

}  // namespace dualarm
