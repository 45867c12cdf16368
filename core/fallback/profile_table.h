#pragma once

#include <vector>

#include "core/phase_plane/profile.h"

namespace dualarm {

/// A profile made quick to look up: quintics between states of the exact motion. A proof asks for a position a thousand
/// times, and the exact answer costs a quadrature.
class ProfileTable {
 public:
  explicit ProfileTable(const Profile& profile);

  double duration() const { return knots_.back().time; }  ///< s

  /// Times (s) of the own clock at which the motion turns back, ascending; between them it goes one way.
  const std::vector<double>& turning_times() const { return turning_times_; }

  /// Position (rad) at a time of the own clock, clamped outside [0, duration].
  double position(double time) const;

 private:
  std::vector<Knot> knots_;  ///< torque unused
  std::vector<double> turning_times_;
};

}  // namespace dualarm
