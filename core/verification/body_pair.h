#pragma once

#include "core/verification/carried_body.h"
#include "geometry/clearance.h"

namespace dualarm {

/// Two bodies whose distance matters; they outlive this.
struct BodyPair {
  const CarriedBody* first = nullptr;
  const CarriedBody* second = nullptr;
};

/// The distance of a pair in the middle of an interval of time, and what it proves about all of the interval.
struct DistanceOverTime {
  Clearance in_the_middle;
  double error = 0.0;        ///< m, of FCL's distance in the middle, see clearance_error
  double lower_bound = 0.0;  ///< m, the better of a speed bound and separation_bound
};

/// An interval with a corner of a track inside is served by the speed bound alone.
DistanceOverTime distance_over(const BodyPair& pair, Interval time);

/// Where an interval is best cut in two: at a corner of a track inside of it, else in the middle.
double cut_of(const BodyPair& pair, Interval time);

}  // namespace dualarm
