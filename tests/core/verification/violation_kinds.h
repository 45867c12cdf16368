#pragma once

#include <vector>

#include "core/verification/verify.h"

namespace dualarm {

/// What a verification complains of, in its order.
inline std::vector<ViolationKind> kinds(const Verification& verification) {
  std::vector<ViolationKind> kinds;
  for (const Violation& violation : verification.violations) kinds.push_back(violation.kind);
  return kinds;
}

}  // namespace dualarm
