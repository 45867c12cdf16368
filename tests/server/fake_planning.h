#pragma once

#include <functional>

#include "server/planning_functions.h"

namespace dualarm {

/// Stand-ins for PlanningFunctions::begin_planning.
using FakePlanning = std::function<Outcome(const Problem&, const Budget&, const Observer&)>;
using BeginPlanning = decltype(PlanningFunctions::begin_planning);

/// quick() answers by `planning`.
BeginPlanning quick_planning(FakePlanning planning);

/// quick() gives nothing, search() answers by `planning`; without a plan in hand, or with one.
BeginPlanning search_planning(FakePlanning planning);
BeginPlanning search_planning(FakePlanning planning, Outcome in_hand);

/// Functions that answer at once: an Undecided, a Verification without violations, one contour, a portrait without
/// curves.
PlanningFunctions quick_functions();

/// The same, with this planning.
PlanningFunctions functions_with(BeginPlanning planning);

/// The same, with planning that throws std::logic_error("a bug").
PlanningFunctions functions_with_a_bug();

/// An outcome to be recognised by its explanation.
Outcome undecided(std::string explanation);

/// A plan of this duration (s) and nothing else.
Plan plan_of(double duration);

}  // namespace dualarm
