#include "core/phase_plane/motion_series.h"

#include <algorithm>
#include <boost/math/special_functions/pow.hpp>
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

/// Of states whose polynomials are worked out together, since each step of one waits for the step before. The last
/// group may be larger than what is left of the states.
template <std::size_t kCount>
void MotionSeries::follow_together(double step, std::size_t first, std::span<JointState> states) const {
  std::array<double, kCount> times;
  for (std::size_t i = 0; i < kCount; ++i) times[i] = step * static_cast<double>(first + i + 1);
  std::array<Eigen::Array2d, kCount> sums;
  sums.fill(way_per_time_.back());
  for (std::size_t k = way_per_time_.size() - 1; k-- > 0;) {
    const Eigen::Array2d coefficients = way_per_time_[k];
    for (std::size_t i = 0; i < kCount; ++i) sums[i] = sums[i] * times[i] + coefficients;
  }
  const std::size_t count = std::min(kCount, states.size() - first);
  for (std::size_t i = 0; i < count; ++i) states[first + i] = {sums[i][0] * times[i], sums[i][1]};
}

void MotionSeries::follow(double step, std::span<JointState> states) const {
  constexpr std::size_t kMany = 8;
  constexpr std::size_t kFew = 4;
  std::size_t first = 0;
  for (; first + kMany <= states.size(); first += kMany) follow_together<kMany>(step, first, states);
  for (; first < states.size(); first += kFew) follow_together<kFew>(step, first, states);
}

double MotionSeries::reach(double most) const {
  constexpr std::size_t kFirstLeftOut = kTerms - kLastTerms;
  double last = 0.0;  // of the way, as `first`, but for as many powers of the time
  for (std::size_t k = kTerms; k-- > kFirstLeftOut;) last = last * most + std::abs(way_[k]);
  const double first = std::abs(way_[1]) + std::abs(way_[2]) * most;
  const double part = last / first * boost::math::pow<kFirstLeftOut - 1>(most);
  if (part <= kLeftOut) return most;
  // Shorter times leave out a part that is smaller by this power at least.
  const double reach = most * std::pow(kLeftOut / part, 1.0 / static_cast<double>(kFirstLeftOut - 2));
  return std::isfinite(reach) ? reach : 0.0;
}

}  // namespace dualarm
