#include "core/findings.h"

#include <algorithm>

namespace dualarm {

double KnownBounds::of_every_plan() const {
  return std::max({fastest, demanded.duration, visit ? visit->duration : 0.0});
}

void Findings::begin(std::string_view phase) {
  phase_ = phase;
  if (observer_.on_status) observer_.on_status(status());
}

void Findings::found(const Plan& plan) const {
  if (observer_.on_incumbent) observer_.on_incumbent(plan);
}

PlanningStatus Findings::status() const {
  return {phase_, bounds.of_every_plan(), statistics.fallback_evaluation_count};
}

Undecided Findings::undecided(double seconds_spent) const {
  return {remedy, tried, seconds_spent, bounds.of_every_plan()};
}

}  // namespace dualarm
