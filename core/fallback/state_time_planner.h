#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "core/fallback/edge.h"
#include "core/model/budget.h"
#include "core/model/problem.h"

namespace dualarm {

/// Evaluations after which a search ends unless told otherwise: some tenths of a second for two bare arms.
inline constexpr int kDefaultEvaluationLimit = 12000;

/// Bytes that the nodes of a search's tree may take unless told otherwise.
inline constexpr std::size_t kDefaultSearchMemory = std::size_t{32} << 20;

/// A schedule of which it is known elsewhere that it holds.
struct KnownSchedule {
  Schedule schedule;
  double duration = 0.0;  ///< s
};

/// What a search has to keep to.
struct SearchRules {
  double clearance = 0.0;                           ///< m: the demanded one with the planner's margin added
  int evaluation_limit = kDefaultEvaluationLimit;   ///< > 0
  std::size_t memory_limit = kDefaultSearchMemory;  ///< bytes; a tree that takes as much is begun anew
  double lower_bound = 0.0;                         ///< s, that no plan is below: the search ends when it is met
  std::optional<KnownSchedule> known = {};          ///< begins from it, and tells and returns faster ones only
  std::function<void(const Schedule&, double)> on_incumbent = {};  ///< told each time a plan is found that takes (s) at
                                                                   ///< least a hundredth less than the one told before
  std::function<void(int)> on_status = {};                         ///< told the evaluations so far, now and then
};

struct SearchResult {
  std::optional<Schedule> schedule;  ///< the fastest found, collision-free by the search's own judgement; not verified;
                                     ///< nothing where none is faster than what was known
  double duration = 0.0;             ///< s, of the schedule
  double first_duration = 0.0;       ///< s, of the first plan that was found
  int evaluation_count = 0;          ///< samples drawn, edges tried, changes and proofs tried
  int tree_count = 0;                ///< trees grown from the start
  int node_count = 0;                ///< of the largest tree
  std::size_t memory = 0;            ///< bytes that its nodes took
  bool budget_ran_out = false;       ///< stopped by the budget and not by its own count of evaluations
};

/// Searches motions of both arms by trees in state-time space (OMPL), then shortens what they found. Theory, section 6.
/// `systems` are the loaded arms' and have to outlive the schedule.
///
/// Ends after about as many evaluations as the rules allow once there is a plan or one is known, and four times as many
/// if there is none (a last improvement is finished); the same problem, seed and rules give the same schedule, whatever
/// else runs. A budget that runs out before leaves the best found so far. No schedule: none found, nothing proven.
/// Intermediate positions may lie in the paper's conservative set (RegionModel::kPaper): the search keeps bodies apart,
/// not to that set.
SearchResult search_state_time(const Problem& problem, const Systems& systems, const SearchRules& rules,
                               const Budget& budget);

}  // namespace dualarm
