#pragma once

#include <vector>

#include "core/coordination/forbidden_set.h"
#include "core/model/interval_set.h"
#include "core/phase_plane/profile.h"
#include "geometry/interval_list.h"

namespace dualarm {

/// The start delays with which two motions collide, estimated in a tenth of the time of `forbidden_delays` from slices
/// at some positions of arm 1: for searches that compare motions. Nothing that is found here is proven to be free.
class SampledDelays {
 public:
  /// Safe windows narrower than `closed`, a part of the longer duration, count as forbidden: they may be none.
  SampledDelays(const ForbiddenSet& forbidden, const Profile& first, const Profile& second, double closed);

  IntervalSet forbidden() const;

  /// Seeks the ends of the forbidden interval at whose end a delay (s) lies between the samples, too.
  void sharpen_near(double delay);

 private:
  struct Sample {
    const Leg* leg = nullptr;  ///< nothing while arm 1 stands
    double position = 0.0;     ///< rad, of arm 1
    Interval delays;           ///< s
  };

  IntervalList delays_at(double position, double earliest, double latest) const;
  void add(const Leg* leg, double position, double earliest, double latest);
  double sharpened(const Sample& sample, double sign) const;

  const ForbiddenSet* forbidden_;
  const Profile* first_;
  const Profile* second_;
  Interval extent_;  ///< rad, of the second motion
  double longest_;   ///< s, of both durations
  double closed_;    ///< s, of safe windows that are closed
  std::vector<Sample> samples_;
};

}  // namespace dualarm
