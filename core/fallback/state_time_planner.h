#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/fallback/itinerary.h"
#include "core/model/budget.h"
#include "core/model/problem.h"
#include "core/phase_plane/profile.h"

namespace dualarm {

/// Evaluations after which a search ends unless told otherwise: some tenths of a second for two bare arms.
inline constexpr int kDefaultEvaluationLimit = 6000;

struct SearchResult {
  std::optional<Schedule> schedule;  ///< the fastest found, collision-free by the search's own judgement; not verified
  double duration = 0.0;             ///< s, of the schedule
  int evaluation_count = 0;          ///< samples drawn, edges tried, changes and proofs tried
  bool budget_ran_out = false;       ///< stopped by the budget and not by its own count of evaluations
};

/// Searches motions of both arms by a tree in state-time space (OMPL), then shortens what it found. Theory, section 6.
/// `systems` are the loaded arms' and have to outlive the schedule. `clearance` (m) is the demanded one with the
/// planner's margin added. Arms rest at the problem's starts and goals; velocities there are not looked at. At the
/// goals they stay: objects that move by themselves leave them `earliest_end` (s) at the earliest.
///
/// Ends after about `evaluation_limit` evaluations (> 0; a last improvement is finished); the same problem, seed and
/// limit give the same schedule, whatever else runs. A budget that runs out before leaves the best found so far.
/// No schedule: none found, nothing proven. Intermediate positions may lie in the paper's conservative set
/// (RegionModel::kPaper): the search keeps bodies apart, not to that set. Start delays are not bounded here.
SearchResult search_state_time(const Problem& problem, const Systems& systems, double clearance, double earliest_end,
                               int evaluation_limit, const Budget& budget);

}  // namespace dualarm
