#pragma once

#include <memory>
#include <optional>

#include "core/model/budget.h"
#include "core/observer.h"
#include "core/plan.h"

namespace dualarm {

/// One planning run in two steps, so that quick work and slow work may wait in different queues. Problem and
/// observer outlive it. Every plan has passed `verify`. The same problem gives the same plan; only a budget that runs
/// out can turn a plan of the search into Undecided. Throws std::logic_error for bugs only (a problem that is not valid
/// in the sense of problem.h is one).
class PlanningRun {
 public:
  PlanningRun(const Problem& problem, const Budget& budget, const Observer& observer);
  ~PlanningRun();

  /// The analytic methods: milliseconds. Nothing where only the search can decide, or may find a faster plan than they
  /// did; otherwise the answer.
  std::optional<Outcome> quick();

  /// What is answered if the search cannot have its turn after quick() gave nothing: the plan that the analytic methods
  /// found, if they did.
  std::optional<Outcome> in_hand();

  /// The search in state-time space, after quick() gave nothing: until it is done or this budget is exhausted, which
  /// takes the place of the run's, because the search may have had to wait for its turn.
  Outcome search(const Budget& budget);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Both steps: the fastest verified motion of both arms, or why there is none.
Outcome plan(const Problem& problem, const Budget& budget, const Observer& observer = {});

}  // namespace dualarm
