#pragma once

#include <array>

#include "core/passage/gate.h"
#include "core/passage/through.h"

namespace dualarm {

using Travellers = std::array<Traveller, kArmCount>;

/// What a gate demands of motions that cross it.
struct GateBound {
  double duration = 0.0;  ///< s, that no pair of motions of the families through it is faster than; may be infinite
  int early_arm = 0;      ///< index of the arm that hurries to the gate, while the other one leaves it late
  Passing early;          ///< how that arm gets there within the duration
  Passing late;           ///< how the other arm leaves within it
};

/// T_bound(gate) = min { T : both arms can be at the gate at one time, and start and end within T }. Theory, section 4.
GateBound gate_bound(const Travellers& travellers, const Gate& gate);

/// What a gate takes if nothing is hurried, at much less cost.
struct GateEstimate {
  double duration = 0.0;  ///< s, at least that of the gate's bound
  double crossing = 0.0;  ///< s, of the part of it that the gate is to blame for: to the gate, and on from it
};

GateEstimate gate_estimate(const Travellers& travellers, const Gate& gate);

}  // namespace dualarm
