#pragma once

#include <optional>

#include "core/verification/carried_body.h"
#include "core/verification/separation.h"
#include "geometry/clearance.h"

namespace dualarm {

/// Two bodies whose distance matters; they outlive this.
struct BodyPair {
  const CarriedBody* first = nullptr;
  const CarriedBody* second = nullptr;
};

/// The distance of a pair in the middle of an interval of time, and what it proves about all of the interval: by the
/// speed of both bodies, and by separation, which an interval with a corner of a track inside is not served by.
class DistanceOverTime {
 public:
  DistanceOverTime(const BodyPair& pair, Interval time);

  const Clearance& in_the_middle() const { return in_the_middle_; }
  double error() const { return error_; }  ///< m, of FCL's distance in the middle, see clearance_error

  /// m, over each half of the interval.
  double least_before() const;
  double least_after() const;

  /// The time (s) around the middle during which the distance is nowhere below `distance` (m); only the middle where
  /// nothing is known.
  Interval keeps(double distance) const;

 private:
  Interval time_;
  Clearance in_the_middle_;
  double error_;
  double by_speed_;  // m
  std::optional<Separation> separation_;
};

/// Where an interval is best cut in two: at a corner of a track inside of it, else in the middle.
double cut_of(const BodyPair& pair, Interval time);

}  // namespace dualarm
