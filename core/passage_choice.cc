#include "core/passage_choice.h"

#include <algorithm>
#include <utility>

#include "core/start_choice.h"

namespace dualarm {
namespace {

/// Moving objects may ask for other start times, or leave none: false if the plan takes `known` (s) or more then.
bool gives_way_to_objects(const PreparedProblem& prepared, PassagePlan& plan, double known, const Budget& budget) {
  if (!prepared.has_moving_objects()) return true;
  Problem any_method = prepared.problem();
  any_method.options.methods.clear();
  const StartChoice choice =
      choose_starts(any_method, prepared.forbidden(), prepared.clearance(), plan.motions[0], plan.motions[1], budget);
  if (choice.times) plan.times = *choice.times;
  return choice.times && choice.times->duration < known;
}

}  // namespace

Schedule schedule_of(PassagePlan plan) {
  Schedule schedule;
  schedule[0].push_back({plan.times.first, std::move(plan.motions[0])});
  schedule[1].push_back({plan.times.second, std::move(plan.motions[1])});
  return schedule;
}

std::optional<PassagePlan> fastest_passage(const PreparedProblem& prepared, const Passages& passages, double known,
                                           const Budget& budget) {
  const Travellers& travellers = passages.travellers;
  const double least = std::max(travellers[0].fastest.duration(), travellers[1].fastest.duration());
  std::optional<PassagePlan> best;
  for (const Way& way : passages.bound.ways) {
    auto found = passage_plan(prepared.forbidden(), travellers, way, least, known,
                              prepared.problem().options.max_start_delay, budget);
    if (!found || !gives_way_to_objects(prepared, *found, known, budget)) continue;
    known = found->times.duration;
    best = std::move(found);
  }
  return best;
}

}  // namespace dualarm
