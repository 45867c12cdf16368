#pragma once

#include <array>
#include <string>

#include "core/model/problem.h"

namespace dualarm {

/// The stretch of a joint range that fixed objects leave around start and goal. With one joint an arm never gets past
/// what ends it.
struct FreeRange {
  Interval range;        ///< rad
  std::string below;     ///< the object that ends it below; empty where the joint range does
  std::string above;     ///< the same above
  std::string below_by;  ///< what of the arm would meet that object: its link or what it carries
  std::string above_by;  ///< the same above
};

/// The free range of an arm that keeps `clearance` (m) from all fixed objects. Start and goal lie in the joint range;
/// where an object stands in one of them or between them there is none, and the whole joint range is returned:
/// refuse_sweeps gives the answer for that.
FreeRange free_range(const Problem& problem, int arm, double clearance);

/// The problem with both arms' free ranges as their joint ranges.
Problem within_free_ranges(Problem problem, const std::array<FreeRange, kArmCount>& free);

}  // namespace dualarm
