#pragma once

#include <vector>

#include "core/verification/carried_body.h"

namespace dualarm {

/// Every body of a problem: both arms', the fixed and the tracked ones.
inline std::vector<const CarriedBody*> all_of(const CarriedBodies& bodies) {
  std::vector<const CarriedBody*> found;
  for (const auto* group : {&bodies.moving[0], &bodies.moving[1], &bodies.fixed, &bodies.tracked}) {
    for (const CarriedBody& body : *group) found.push_back(&body);
  }
  return found;
}

}  // namespace dualarm
