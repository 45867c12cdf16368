#include "geometry/motion_bound.h"

#include <algorithm>

namespace dualarm {

double reach(const Capsule& in_link_frame) {
  const double farthest_end = std::max(in_link_frame.start.head<2>().norm(), in_link_frame.end.head<2>().norm());
  return farthest_end + in_link_frame.radius;
}

}  // namespace dualarm
