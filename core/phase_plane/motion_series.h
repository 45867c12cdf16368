#pragma once

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

  /// The way (rad) since the state, and the velocity, at a time (s) from it.
  PlaneState at(double time) const;

 private:
  static constexpr std::size_t kTerms = 20;

  std::array<double, kTerms> way_;       ///< coefficients of powers of time
  std::array<double, kTerms> velocity_;  ///< the same of the velocity, the last one 0
};

}  // namespace dualarm
