#pragma once

#include <optional>

#include "core/model/interval_set.h"
#include "core/plan.h"

namespace dualarm {

/// The answer if the start or the goal lies in the paper's set, where RegionModel::kPaper asks for it.
std::optional<Infeasible> refuse_paper_set(const Problem& problem, double clearance);

/// By how much (m) the closest bodies of start and goal keep more than the demanded clearance; negative if they do not.
/// Infinite where no two bodies can meet.
double end_state_slack(const Problem& problem);

/// The answer if that slack is less than `margin` (m), which proofs of clearance need.
Infeasible refuse_end_states(const Problem& problem, double margin);

/// The answer if a fixed object stands between start and goal of an arm: with one joint, every motion has to pass it.
std::optional<Infeasible> refuse_sweeps(const Problem& problem, double margin);

/// The answer if every delay up to the allowed one collides and no other method is allowed.
Infeasible refuse_delays(const Problem& problem, const IntervalSet& safe_delays);

/// The answer if the forbidden set parts the start from the goal.
Infeasible refuse_parted(const Problem& problem);

}  // namespace dualarm
