#pragma once

#include <optional>

#include "core/phase_plane/system.h"

namespace dualarm {

/// dt/d(root) along an arc whose work is a SineWork, at position = anchor + away (root^2 - behind): what is left of the
/// time's rate when the singularity of a rest end is gone. Integrated by Gauss-Kronrod rules, all nodes at once.
class SineSlowness {
 public:
  /// `anchor_velocity` in rad/s, `away` +1 or -1, `behind` in rad, >= 0.
  SineSlowness(const SineWork& work, double anchor_velocity, double away, double behind)
      : work_(work), anchor_square_(anchor_velocity * anchor_velocity), away_(away), behind_(behind) {}

  /// Time (s) from the root `first` to the root `last` >= first (rad^1/2), to 1e-13. Nothing where the way is too long
  /// for the sines' series, or no rule agrees with the one within it: then the interval has to be subdivided.
  std::optional<double> time(double first, double last) const;

 private:
  template <int kNodes>
  std::optional<double> by_rule(double first, double last) const;

  SineWork work_;
  double anchor_square_;  ///< (rad/s)2
  double away_;
  double behind_;
};

}  // namespace dualarm
