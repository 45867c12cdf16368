#pragma once

#include "core/fallback/state_time_planner.h"
#include "tests/core/fallback/scenes.h"

namespace dualarm {

inline constexpr double kClearance = 1e-4;  // m, what the search keeps
inline constexpr int kInstants = 2000;      // at which gaps are sampled

inline SearchResult search(const Problem& problem, const ArmSystems& arms, int limit = kDefaultEvaluationLimit,
                           const Budget& budget = {}) {
  SearchRules rules;
  rules.clearance = kClearance;
  rules.evaluation_limit = limit;
  return search_state_time(problem, arms.both(), rules, budget);
}

}  // namespace dualarm
