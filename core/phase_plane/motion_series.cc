#include "core/phase_plane/motion_series.h"

#include <algorithm>
#include <boost/math/special_functions/pow.hpp>
#include <cmath>

#include "core/model/wide_registers.h"

namespace dualarm {
namespace {

/// What the last terms may be of the first two, and how many are looked at: symmetry lets some vanish, such as all but
/// each fourth of a pendulum that starts at the height of its joint.
constexpr double kLeftOut = 1e-16;
constexpr std::size_t kLastTerms = 4;

}  // namespace

std::optional<MotionSeries> MotionSeries::about(const System& system, Extreme extreme, JointState state) {
  MotionSeries series;
  if (!system.extremal_series(extreme, state, series.way_)) return std::nullopt;
  for (std::size_t k = 0; k + 1 < kTerms; ++k) series.velocity_[k] = static_cast<double>(k + 1) * series.way_[k + 1];
  return series;
}

/// Of four states. Each polynomial is summed up by even and by odd powers, since each step of a sum waits for the step
/// before.
[[gnu::always_inline]] inline void MotionSeries::follow_four(const Four& time, Four& way, Four& velocity) const {
  const Four square = time * time;
  constexpr std::size_t kLast = kTerms - 2;  // the last even power of way / time
  static_assert(kLast % 2 == 0);
  Four even_way = Four() + way_[kLast + 1];
  Four odd_way = Four();
  Four even_velocity = Four() + velocity_[kLast];
  Four odd_velocity = Four();
  for (std::size_t k = kLast; k >= 2; k -= 2) {
    odd_way = odd_way * square + way_[k];
    odd_velocity = odd_velocity * square + velocity_[k - 1];
    even_way = even_way * square + way_[k - 1];
    even_velocity = even_velocity * square + velocity_[k - 2];
  }
  way = (even_way + odd_way * time) * time;
  velocity = even_velocity + odd_velocity * time;
}

void MotionSeries::follow(double step, std::span<JointState> states) const {
  with_wide_registers([&] {
    Four count = {1.0, 2.0, 3.0, 4.0};
    for (std::size_t first = 0; first < states.size(); first += 4, count += 4.0) {
      Four way;
      Four velocity;
      follow_four(step * count, way, velocity);
      // The last four may be more than what is left of the states.
      for (std::size_t i = 0; i < std::min<std::size_t>(4, states.size() - first); ++i) {
        states[first + i] = {way[i], velocity[i]};
      }
    }
  });
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
