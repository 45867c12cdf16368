#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

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

  /// The way (rad) since the state, as the position, and the velocity, at one, two, three... steps (s) from it.
  void follow(double step, std::span<JointState> states) const;

 private:
  static constexpr std::size_t kTerms = 20;

  template <std::size_t kCount>
  void follow_together(double step, std::size_t first, std::span<JointState> states) const;

  std::array<double, kTerms> way_;                       ///< coefficients of powers of time
  std::array<Eigen::Array2d, kTerms - 1> way_per_time_;  ///< the same of way / time and of the velocity
};

}  // namespace dualarm
