#include "core/exact_starts.h"

#include <array>
#include <cmath>

#include "core/passage/joined.h"
#include "core/start_choice.h"

namespace dualarm {
namespace {

/// s: a wait this short is none.
constexpr double kNoWait = 1e-11;

/// All motions of an arm as one. Nothing where it waits between them.
std::optional<Profile> uninterrupted(const System& system, const std::vector<TimedProfile>& motions) {
  Profile whole = motions.front().profile;
  double end = motions.front().start_time + whole.duration();
  for (std::size_t i = 1; i < motions.size(); ++i) {
    if (motions[i].start_time - end > kNoWait) return std::nullopt;
    whole = joined(system, whole, motions[i].profile);
    end += motions[i].profile.duration();
  }
  return whole;
}

}  // namespace

std::optional<TimedSchedule> with_exact_starts(const PreparedProblem& prepared, const Schedule& schedule,
                                               double duration, const Budget& budget) {
  if (budget.exhausted()) return std::nullopt;
  const auto first = uninterrupted(prepared.system(0), schedule[0]);
  const auto second = uninterrupted(prepared.system(1), schedule[1]);
  if (!first || !second) return std::nullopt;
  Problem any_method = prepared.problem();
  any_method.options.methods.clear();
  const StartChoice choice =
      choose_starts(any_method, prepared.forbidden(), prepared.clearance(), *first, *second, budget);
  if (!choice.times || choice.times->duration >= duration) return std::nullopt;
  const StartTimes& times = *choice.times;
  return TimedSchedule{{std::vector{TimedProfile{times.first, *first}}, {TimedProfile{times.second, *second}}},
                       times.duration};
}

}  // namespace dualarm
