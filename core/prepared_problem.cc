#include "core/prepared_problem.h"

#include <algorithm>

#include "core/refusal.h"

namespace dualarm {
namespace {

/// m. Where the start or the goal leaves less, half of what it leaves, but not less than the proof needs on arms of any
/// size.
constexpr double kPlanningMargin = 1e-4;
constexpr double kLeastMargin = 1e-5;

/// An arm that no motion takes out of the stretch that fixed objects leave it.
SingleJointArm system_within(Arm arm, const FreeRange& free) {
  arm.joint_range = free.range;
  return SingleJointArm(arm);
}

std::array<FreeRange, kArmCount> free_ranges(const Problem& problem, double clearance) {
  return {free_range(problem, 0, clearance), free_range(problem, 1, clearance)};
}

}  // namespace

PreparedProblem::PreparedProblem(const Problem& problem)
    : problem_(problem),
      slack_(end_state_slack(problem)),
      margin_(std::clamp(0.5 * slack_, kLeastMargin, kPlanningMargin)),
      arms_{loaded_arm(problem, 0), loaded_arm(problem, 1)},
      free_(free_ranges(problem, clearance())),
      systems_{system_within(arms_[0], free_[0]), system_within(arms_[1], free_[1])},
      forbidden_(problem, clearance()),
      has_moving_objects_(!tracked_bodies(problem).empty()) {}

Problem PreparedProblem::within_free_ranges_at(double clearance) const {
  return within_free_ranges(problem_, clearance == this->clearance() ? free_ : free_ranges(problem_, clearance));
}

bool PreparedProblem::rests_at_ends() const {
  return std::all_of(problem_.tasks.begin(), problem_.tasks.end(),
                     [](const Task& task) { return task.start.velocity == 0.0 && task.goal.velocity == 0.0; });
}

}  // namespace dualarm
