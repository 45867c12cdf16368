#include "core/start_choice.h"

#include <algorithm>
#include <limits>

#include "core/coordination/diagram.h"
#include "core/coordination/moving_objects.h"
#include "core/wording.h"

namespace dualarm {
namespace {

constexpr const char* kOutOfBudget = "start delays: the budget ran out";

/// s. Negative where no method is allowed that knows start times.
double longest_delay(const PlanOptions& options) {
  if (options.allows(Method::kDelay) || options.allows(Method::kPassage)) return options.max_start_delay;
  return options.allows(Method::kSimultaneous) ? 0.0 : -1.0;
}

/// An arm that can neither wait nor be early, and would have to be slower than its fastest motion.
std::string why_stretch(const Problem& problem, double first_duration, double second_duration) {
  const int shorter = first_duration < second_duration ? 0 : 1;
  return worded("start delays: ", problem.arms[shorter].name,
                " is in motion at its start and at its goal, so that its ", std::min(first_duration, second_duration),
                " s would have to be stretched to the ", std::max(first_duration, second_duration), " s of ",
                problem.arms[1 - shorter].name, "; fastest motions are never stretched");
}

std::string why_none(const Problem& problem) {
  std::string line = "start delays: none that is allowed avoids a collision of the fastest motions";
  if (!tracked_bodies(problem).empty()) line += ", with each other or with a moving object";
  const bool rests_at_ends = std::all_of(problem.tasks.begin(), problem.tasks.end(), [](const Task& task) {
    return task.start.velocity == 0.0 && task.goal.velocity == 0.0;
  });
  if (!rests_at_ends) {
    line += "; arms in motion at their start cannot wait, those in motion at their goal not be early";
  }
  return line;
}

/// What moving objects leave an arm, s from the start of the plan. Nothing if the budget ran out.
std::optional<IntervalSet> starts_between_objects(const Problem& problem, int arm, double clearance,
                                                  const Profile& motion, const Budget& budget) {
  const auto forbidden = forbidden_starts(motion, problem.arms[arm].base, moving_bodies(problem, arm),
                                          tracked_bodies(problem), clearance, budget);
  if (!forbidden) return std::nullopt;
  return forbidden->complement({0.0, std::numeric_limits<double>::infinity()});
}

}  // namespace

StartChoice choose_starts(const Problem& problem, const ForbiddenSet& forbidden, double clearance, const Profile& first,
                          const Profile& second, const Budget& budget) {
  const Timing first_timing = timing_of(first);
  const Timing second_timing = timing_of(second);
  const Interval possible = possible_delays(first_timing, second_timing);
  if (possible.empty()) return {{}, {}, why_stretch(problem, first.duration(), second.duration())};
  const auto delays = forbidden_delays(forbidden, first, second, budget);
  if (!delays) return {{}, {}, kOutOfBudget};
  StartChoice choice;
  choice.safe_delays = delays->complement(possible);
  const auto of_first = starts_between_objects(problem, 0, clearance, first, budget);
  const auto of_second = starts_between_objects(problem, 1, clearance, second, budget);
  if (!of_first || !of_second) {
    choice.why_not = kOutOfBudget;
    return choice;
  }
  const double longest = longest_delay(problem.options);
  const SafeStarts safe = {*choice.safe_delays, *of_first, *of_second};
  if (longest >= 0.0) choice.times = best_start_times(safe, first_timing, second_timing, longest);
  if (!choice.times) choice.why_not = why_none(problem);
  return choice;
}

}  // namespace dualarm
