#pragma once

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

  using Four [[gnu::vector_size(4 * sizeof(double))]] = double;

  void follow_four(const Four& time, Four& way, Four& velocity) const;

  std::array<double, kTerms> way_;           ///< coefficients of powers of time
  std::array<double, kTerms - 1> velocity_;  ///< the same of the velocity
};

}  // namespace dualarm
