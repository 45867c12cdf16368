#pragma once

#include <boost/container/small_vector.hpp>

#include "geometry/interval.h"

namespace dualarm {

/// Some intervals, as a rule so few that they need no memory of their own. Copied, never moved: gcc 12 takes the move
/// of a small_vector for a read beyond its end.
class IntervalList : public boost::container::small_vector<Interval, 6> {
 public:
  using boost::container::small_vector<Interval, 6>::small_vector;
  IntervalList() = default;
  IntervalList(const IntervalList&) = default;
  IntervalList& operator=(const IntervalList&) = default;
};

}  // namespace dualarm
