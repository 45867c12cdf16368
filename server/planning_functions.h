#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/arm_portrait.h"
#include "core/coordination/region.h"
#include "core/observer.h"
#include "core/plan.h"

namespace dualarm {

/// One planning run in the two steps of core/planner.h, whose PlanningRun it stands for.
class PlanningSteps {
 public:
  virtual ~PlanningSteps() = default;

  /// Nothing where only the search can decide, or may find a faster plan.
  virtual std::optional<Outcome> quick() = 0;

  /// The plan that is there without the search, after quick() gave nothing.
  virtual std::optional<Outcome> in_hand() = 0;

  /// After quick() gave nothing; perhaps later and on another thread, with what is left of the budget.
  virtual Outcome search(const Budget& budget) = 0;
};

/// What the service calls: PlanningRun, verify, forbidden_region and arm_portrait of core; tests put others in their
/// place. Problem and observer outlive the steps.
struct PlanningFunctions {
  std::function<std::unique_ptr<PlanningSteps>(const Problem&, const Budget&, const Observer&)> begin_planning;
  std::function<Verification(const Problem&, const Trajectory&, const Budget&, bool check_end_states)> verify;
  std::function<std::optional<std::vector<Contour>>(const Problem&, int resolution, const Budget&)> forbidden_region;
  std::function<std::optional<ArmPortrait>(const Problem&, int arm, int resolution, const Budget&)> arm_portrait;
};

/// Those of core.
PlanningFunctions core_functions();

}  // namespace dualarm
