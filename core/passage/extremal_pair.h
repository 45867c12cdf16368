#pragma once

#include <optional>

#include "core/passage/gate_bound.h"

namespace dualarm {

/// The two motions that meet in a gate within the duration of a plan: the early arm's begins with the plan, the late
/// one's ends with it.
struct ExtremalPair {
  int early_arm = 0;  ///< index
  Profile early;
  Profile late;
  double duration = 0.0;  ///< s, of the plan

  /// When (s) the late arm's motion begins.
  double wait() const { return duration - late.duration(); }
};

/// The pair through a gate within `duration` (s), at least that of the gate's bound; nothing where a motion does not
/// exist.
std::optional<ExtremalPair> extremal_pair(const Travellers& travellers, const Gate& gate, const GateBound& bound,
                                          double duration);

/// Whether the pair goes through another gate in turn, in each order in which that binds: then the other gate's bound
/// is no larger than the pair's duration.
bool passes_in_turn(const ExtremalPair& pair, const Travellers& travellers, const Gate& gate);

}  // namespace dualarm
