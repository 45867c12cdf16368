#pragma once

#include <functional>
#include <string_view>

#include "core/plan.h"

namespace dualarm {

/// How far a planning run has come.
struct PlanningStatus {
  std::string_view phase;    ///< what is being done, for people; outlives the program
  double lower_bound = 0.0;  ///< s, of all plans, as far as known
  int fallback_evaluation_count = 0;
};

/// Who is told while a plan is being made. Called on the planning thread, often: what takes long delays the plan. What
/// is not set is not called.
struct Observer {
  std::function<void(const PlanningStatus&)> on_status;
  std::function<void(const Plan&)> on_incumbent;  ///< a verified plan, faster than each one before
};

}  // namespace dualarm
