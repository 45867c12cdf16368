#pragma once

#include <vector>

#include "core/model/budget.h"
#include "core/passage/slowest_gate.h"

namespace dualarm {

/// What all plans that keep out of a forbidden set need at least.
struct PassageBound {
  double duration = 0.0;  ///< s; 0 where no gate was found, infinite where no path leads to the goal
  std::vector<Way> ways;  ///< the ways around the obstacle that gives the bound, the fastest first: one or two
  bool is_whole = true;   ///< false if the budget ran out on the way; the bound is true all the same
};

/// The largest passage bound over the obstacles of a forbidden plane that the arms' fastest motions meet: for each
/// obstacle the better of its two sides, for each side the slowest of its gates, sought along the obstacle's border.
/// True for pairs of motions of the travellers' families (through.h): for all motions, where those are complete.
/// The ways around the obstacles of a plane that is a margin wider, if given, are where the search begins and, on their
/// sides, ends: the slowest gate there is the slowest here, too, to what the margin makes. Theory, section 4.
PassageBound passage_bound(const ForbiddenPlane& plane, const Travellers& travellers, const Budget& budget,
                           const std::vector<Way>& near_by = {});

}  // namespace dualarm
