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

/// All bodies of a problem. Motions outlive this.
struct CarriedBodies {
  std::array<std::vector<CarriedBody>, kArmCount> moving;
  std::vector<CarriedBody> fixed;
};

/// Two bodies whose distance matters; they outlive this.
struct BodyPair {
  const CarriedBody* first = nullptr;
  const CarriedBody* second = nullptr;
  double error = 0.0;  ///< m, FCL's, see clearance_error
};

/// `rest` is the motion of what stands still.
CarriedBodies carried_bodies(const Problem& problem, const std::array<Interpolant, kArmCount>& motions,
                             const Interpolant& rest);

/// Every pair of bodies that may meet.
std::vector<BodyPair> pairs_that_may_meet(const CarriedBodies& bodies);

/// Lower bound (m, perhaps negative) on the distance of a pair at any time: that of the discs that they can sweep.
double swept_distance(const BodyPair& pair);

/// The distance of a pair in the middle of an interval of time, and what it proves about all of the interval.
struct DistanceOverTime {
  Clearance in_the_middle;
  double lower_bound = 0.0;  ///< m
};

DistanceOverTime distance_over(const BodyPair& pair, Interval time);

}  // namespace dualarm
