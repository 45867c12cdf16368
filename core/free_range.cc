#include "core/free_range.h"

#include <algorithm>

#include "core/coordination/forbidden_set.h"

namespace dualarm {

FreeRange free_range(const Problem& problem, int arm, double clearance) {
  const Interval whole = problem.arms[arm].joint_range;
  const auto [low, high] = std::minmax({problem.tasks[arm].start.position, problem.tasks[arm].goal.position});
  FreeRange free{whole, {}, {}, {}, {}};
  const std::vector<Body> fixed = fixed_bodies(problem);
  for (const Body& moving : moving_bodies(problem, arm)) {
    for (const Body& standing : fixed) {
      const IntervalSet blocked =
          blocked_positions(problem.arms[arm].base, moving.shape, standing.shape, clearance, whole);
      for (const Interval& stretch : blocked.intervals()) {
        if (stretch.upper >= low && stretch.lower <= high) return {whole, {}, {}, {}, {}};
        if (stretch.upper < low && stretch.upper >= free.range.lower) {
          free.range.lower = stretch.upper;
          free.below = standing.name;
          free.below_by = moving.name;
        }
        if (stretch.lower > high && stretch.lower <= free.range.upper) {
          free.range.upper = stretch.lower;
          free.above = standing.name;
          free.above_by = moving.name;
        }
      }
    }
  }
  return free;
}

Problem within_free_ranges(Problem problem, const std::array<FreeRange, kArmCount>& free) {
  for (int arm = 0; arm < kArmCount; ++arm) problem.arms[arm].joint_range = free[arm].range;
  return problem;
}

}  // namespace dualarm
