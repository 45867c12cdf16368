#pragma once

#include <optional>
#include <vector>

#include "core/model/budget.h"
#include "core/passage/extremal_pair.h"
#include "core/passage/gate_bound.h"
#include "core/passage/obstacle.h"

namespace dualarm {

/// One way around an obstacle: the gate on it that takes longest to get through.
struct Way {
  Gate gate;
  GateBound bound;
  std::optional<ExtremalPair> pair = {};  ///< through the gate within the bound's duration, if it was looked at
};

/// The slowest gate of one side (0 or 1) of an obstacle, sought along its border: from where unhurried motions meet it
/// most, or from the gates of `near_by` that lie on this side, if there are any. Nothing if no gate of that side is
/// known. Any gate bounds all plans, so that a search which the budget ends is true all the same. Theory, section 4.
std::optional<Way> slowest_gate(const ForbiddenPlane& plane, const Travellers& travellers, Obstacle& obstacle, int side,
                                const std::vector<Way>& near_by, const Budget& budget);

}  // namespace dualarm
