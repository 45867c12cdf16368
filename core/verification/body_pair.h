#pragma once

#include <array>
#include <vector>

#include "core/model/problem.h"
#include "core/verification/interpolant.h"
#include "geometry/chain.h"
#include "geometry/clearance.h"

namespace dualarm {

/// A body and what carries it. What stands still is carried by a motion that rests, about the world's origin.
struct CarriedBody {
  Body body;  ///< in the frame of the carrier's link
  Base base;
  const Interpolant* motion = nullptr;  ///< of the carrier; outlives this
  double reach = 0.0;                   ///< m
};

/// Two bodies whose distance matters.
struct BodyPair {
  CarriedBody first;
  CarriedBody second;
  double error = 0.0;  ///< m, FCL's, see clearance_error
};

/// Every pair of bodies that may meet. `rest` is the motion of what stands still.
std::vector<BodyPair> pairs_that_may_meet(const Problem& problem, const std::array<Interpolant, kArmCount>& motions,
                                          const Interpolant& rest);

/// The distance of a pair in the middle of an interval of time, and what it proves about all of the interval.
struct DistanceOverTime {
  Clearance in_the_middle;
  double lower_bound = 0.0;  ///< m
};

DistanceOverTime distance_over(const BodyPair& pair, Interval time);

}  // namespace dualarm
