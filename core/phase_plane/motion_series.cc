#include "core/phase_plane/motion_series.h"

#include <algorithm>
#include <cmath>

namespace dualarm {
namespace {

/// What the last terms may be of the first two, and how many are looked at: symmetry lets some vanish, such as all but
/// each fourth of a pendulum that starts at the height of its joint.
constexpr double kLeftOut = 1e-17;
constexpr std::size_t kLastTerms = 4;

}  // namespace

std::optional<MotionSeries> MotionSeries::about(const System& system, Extreme extreme, JointState state) {
  MotionSeries series;
  if (!system.extremal_series(extreme, state, series.way_)) return std::nullopt;
  for (std::size_t k = 0; k + 1 < kTerms; ++k) {
    series.way_per_time_[k] = {series.way_[k + 1], static_cast<double>(k + 1) * series.way_[k + 1]};
  }
  return series;
}

double MotionSeries::reach(double most) const {
  constexpr std::size_t kFirstLeftOut = kTerms - kLastTerms;
  double last = 0.0;  // of the way, as `first`, but for as many powers of the time
  for (std::size_t k = kTerms; k-- > kFirstLeftOut;) last = last * most + std::abs(way_[k]);
  const double first = std::abs(way_[1]) + std::abs(way_[2]) * most;
  const double part = last / first * std::pow(most, static_cast<double>(kFirstLeftOut - 1));
  if (part <= kLeftOut) return most;
  // Shorter times leave out a part that is smaller by this power at least.
  const double reach = most * std::pow(kLeftOut / part, 1.0 / static_cast<double>(kFirstLeftOut - 2));
  return std::isfinite(reach) ? reach : 0.0;
}

}  // namespace dualarm
