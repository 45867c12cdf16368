#pragma once

#include "core/model/problem.h"

namespace dualarm {

/// A ray in the plane of the joint positions, from the forbidden set to the border of the joint rectangle: the pinned
/// arm stands at its position, the other one at `corner_position` or beyond it, above or below. It binds only what has
/// to cross it. Theory, section 4.
struct Gate {
  int pinned_arm = 0;            ///< index
  double pinned_position = 0.0;  ///< rad
  double corner_position = 0.0;  ///< rad, of the other arm
  bool runs_up = true;           ///< from the corner towards larger positions
};

/// Where an arm is in the gate's corner, rad.
inline double position_of(const Gate& gate, int arm) {
  return arm == gate.pinned_arm ? gate.pinned_position : gate.corner_position;
}

}  // namespace dualarm
