#pragma once

#include <vector>

#include "core/verification/body_pair.h"

namespace dualarm {

/// A pair of bodies during an interval of time (s), and a lower bound (m, not above 0 where nothing is known) on its
/// distance meanwhile.
struct BoundedPair {
  BodyPair pair;
  Interval time;
  double swept_distance = 0.0;
};

/// Every pair of bodies that may meet from time 0 to `duration` (s): what moves with one arm against what moves with
/// the other, and against what stands still or moves by itself; and once more after `duration`, while a track goes on,
/// what stands with an arm that has come to rest against what moves by itself. Bounds come from boxes over time, which
/// cost far less than a distance query; bounds of `enough` (m) need no sharper ones.
std::vector<BoundedPair> pairs_that_may_meet(const CarriedBodies& bodies, double duration, double enough);

}  // namespace dualarm
