#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/model/problem.h"

namespace dualarm {

/// What OMPL's control::planners are to be compared with.
enum class TorquePlanner { kRrt, kKpiece, kSst };

const char* name_of(TorquePlanner planner);

/// Looks for motions of both arms with a planner of OMPL's own that samples torques, for some seconds: a planner that
/// ends with its first plan is begun anew until the time is over. `on_better` is told the seconds since the start and
/// the duration (s) of each plan faster than those before. States are positions and velocities, a goal is one as near
/// as kGoalTolerance; bodies are tested at each step of the integration with the same distances as in our own search.
/// The problem has no objects that move by themselves.
void plan_by_torques(const Problem& problem, TorquePlanner planner, double seconds,
                     const std::function<void(double, double)>& on_better);

inline constexpr double kGoalTolerance = 0.1;  ///< rad and rad/s, of all four numbers together

}  // namespace dualarm
