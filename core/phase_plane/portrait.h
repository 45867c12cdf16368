#pragma once

#include <vector>

#include "core/model/problem.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// The curves that shape the fastest motions of a system, as states in order of ascending position.
/// Theory, section 1.2 [paper, figures 3 and 4].
struct PhasePortrait {
  /// The largest velocity at each position from which full braking still keeps the velocity limit and the range;
  /// without a state where not even rest does.
  std::vector<JointState> upper_limit;
  /// The same for falling motions: the smallest (most negative) velocity.
  std::vector<JointState> lower_limit;
  /// The switching curve: states from which one arc of full braking reaches the goal, up to the limits and the range;
  /// rising motions (velocity >= 0) and falling ones. Empty where no arc ends there.
  std::vector<JointState> rising_switch;
  std::vector<JointState> falling_switch;
};

/// The portrait for a goal inside the limits, each curve with `resolution` >= 2 states, evenly spaced in position over
/// the curve's extent.
PhasePortrait draw_portrait(const System& system, JointState goal, int resolution);

}  // namespace dualarm
