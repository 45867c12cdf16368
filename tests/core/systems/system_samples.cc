#include "tests/core/systems/system_samples.h"

#include <algorithm>
#include <cmath>

namespace dualarm {
namespace {

/// `count` + 1 evenly spaced values and the extra ones, ascending.
std::vector<double> spread(Interval over, int count, const std::vector<double>& extra) {
  std::vector<double> values = extra;
  for (int i = 0; i <= count; ++i) values.push_back(std::lerp(over.lower, over.upper, static_cast<double>(i) / count));
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

}  // namespace

SystemSamples::SystemSamples(const System& system) {
  const Interval range = system.range();
  const Interval wide = {range.lower - 0.5 * range.length(), range.upper + 0.5 * range.length()};
  std::vector<double> marks = system.position_bends(wide);
  marks.insert(marks.end(), {range.lower, range.upper});
  everywhere = spread(wide, 1000, marks);
  std::copy_if(everywhere.begin(), everywhere.end(), std::back_inserter(positions),
               [&](double s) { return range.contains(s); });

  std::vector<double> speeds = system.velocity_bends();
  speeds.insert(speeds.end(), {0.0, -kTinyStep, kTinyStep});
  for (const double limit : {system.velocity().lower, system.velocity().upper}) {
    if (std::isfinite(limit)) speeds.push_back(limit);
  }
  const auto [lowest, highest] = std::minmax_element(speeds.begin(), speeds.end());
  velocities = spread({1.5 * *lowest - 1.0, 1.5 * *highest + 1.0}, 30, speeds);
  for (const double s : everywhere) scale = std::max(scale, system.acceleration(s, 0.0).length());
}

}  // namespace dualarm
