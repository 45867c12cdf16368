#pragma once

#include "core/free_range.h"
#include "core/model/budget.h"
#include "core/phase_plane/time_optimal.h"
#include "core/plan.h"
#include "core/systems/single_joint_arm.h"

namespace dualarm {

/// The answer for an arm that has no motion: which limit, where, how much is missing, and the remedy. `arm` with all it
/// carries; `system` is the same arm with `free` as its range. The smallest change that would be enough is worked out
/// where the refusal is proven and the budget allows it.
Infeasible refuse_blocked(const Arm& arm, const Task& task, const SingleJointArm& system, const FreeRange& free,
                          const Blocked& blocked, const Budget& budget = Budget());

}  // namespace dualarm
