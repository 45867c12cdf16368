#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>

#include "core/phase_plane/extremal_rate.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// A motion under one end of the admissible accelerations as a Taylor series in time about a state of it, where the
/// system knows one (System::extremal_series). Some ten knots of a trajectory cost what one step of an integration
/// does. Theory, section 1.1.
class MotionSeries {
 public:
  /// Nothing where the system knows no series.
  static std::optional<MotionSeries> about(const System& system, Extreme extreme, JointState state);

  /// For how long (s, up to `most` >= 0) in both directions of time what is left out is less than rounding.
  double reach(double most) const;

  /// The way (rad) since the state, and the velocity, at times (s) from it. Several at once take little longer than
  /// one: each step of a polynomial waits for the one before.
  template <std::size_t kCount>
  std::array<PlaneState, kCount> at(const std::array<double, kCount>& times) const;
  PlaneState at(double time) const { return at(std::array{time}).front(); }

 private:
  static constexpr std::size_t kTerms = 20;

  std::array<double, kTerms> way_;                       ///< coefficients of powers of time
  std::array<Eigen::Array2d, kTerms - 1> way_per_time_;  ///< the same of way / time and of the velocity
};

template <std::size_t kCount>
std::array<PlaneState, kCount> MotionSeries::at(const std::array<double, kCount>& times) const {
  std::array<Eigen::Array2d, kCount> sums;
  sums.fill(way_per_time_.back());
  for (std::size_t k = way_per_time_.size() - 1; k-- > 0;) {
    const Eigen::Array2d coefficients = way_per_time_[k];
    for (std::size_t i = 0; i < kCount; ++i) sums[i] = sums[i] * times[i] + coefficients;
  }
  std::array<PlaneState, kCount> states;
  for (std::size_t i = 0; i < kCount; ++i) states[i] = {sums[i][0] * times[i], sums[i][1]};
  return states;
}

}  // namespace dualarm
