#pragma once

#include <chrono>

#include "core/model/budget.h"

namespace dualarm {

/// How long a planning run may take: methods end early enough for what they found to be proven.
struct PlanningBudget {
  Budget methods;
  Budget proof;

  explicit PlanningBudget(const Budget& all) : methods(all.leaving(kProofShare, kMostForProof)), proof(all) {}

  static constexpr double kProofShare = 0.2;
  static constexpr std::chrono::milliseconds kMostForProof{250};
};

}  // namespace dualarm
