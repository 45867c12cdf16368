#pragma once

#include <array>

#include "core/passage/gate.h"
#include "core/passage/through.h"

namespace dualarm {

using Travellers = std::array<Traveller, kArmCount>;

/// How far one arm hurries at a gate: the share of its family (through.h), and how fast the times change with it.
struct Haste {
  double share = 0.0;
  double before_slope = 0.0;  ///< s
  double after_slope = 0.0;   ///< s
};

/// What a gate demands of motions that cross it.
struct GateBound {
  double duration = 0.0;  ///< s, that no pair of motions of the families through it is faster than; may be infinite
  int early_arm = 0;      ///< index of the arm that hurries to the gate, while the other one leaves it late
  Passing early;          ///< how that arm gets there within the duration
  Passing late;           ///< how the other arm leaves within it
  double price = 0.0;     ///< what a second more to the gate, or on from it, adds to the duration; 0 if not known
  Haste early_haste;      ///< where the price is known
  Haste late_haste;
};

/// An arm that goes first and one that goes second, at the positions of a gate.
struct Order {
  int early_arm = 0;      ///< index
  double early_at = 0.0;  ///< rad
  double late_at = 0.0;   ///< rad
};

/// The orders in which a gate binds, none to two: an arm that ends beyond the corner need not come back before the
/// other passes.
struct Orders {
  std::array<Order, 2> orders;
  int count = 0;
};

Orders orders_of(const Travellers& travellers, const Gate& gate);

/// T_bound(gate) = min { T : both arms can be at the gate at one time, and start and end within T }. The bound of a
/// gate near by, if given, saves work; so does a `floor` (s): where the bound is no larger, what is answered is no
/// larger either, and says no more. When the budget runs out, what is answered is smaller than the bound. Theory,
/// section 4.
GateBound gate_bound(const Travellers& travellers, const Gate& gate, const GateBound* near_by = nullptr,
                     double floor = 0.0, const Budget& budget = Budget());

/// What a gate takes if nothing is hurried, at much less cost.
struct GateEstimate {
  double duration = 0.0;  ///< s, at least that of the gate's bound
  double crossing = 0.0;  ///< s, of the part of it that the gate is to blame for: to the gate, and on from it
  int early_arm = 0;      ///< index of the arm that goes first, where the crossing takes longer
  Passing early;          ///< how it gets there
  Passing late;           ///< how the other arm leaves
};

GateEstimate gate_estimate(const Travellers& travellers, const Gate& gate);

/// How fast (s/rad) the time to a gate and on from it grows with the gate's pinned position, if its corner moves by
/// `corner_slope` with it: an arm gets to a position a little farther as it goes on. No number where one stands.
/// Theory, section 4.
double crossing_slope(const Gate& gate, double corner_slope, int early_arm, const Passing& early, const Passing& late);

}  // namespace dualarm
