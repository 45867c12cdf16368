#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/fallback/state_time_planner.h"
#include "core/observer.h"
#include "core/passage/bound.h"
#include "core/passage/proof.h"
#include "core/plan.h"

namespace dualarm {

/// What a moving object demands of every plan.
struct VisitBound {
  double duration = 0.0;  ///< s, at least the end of the visit
  ObjectVisit visit;
};

/// What is known of the durations of all plans of a problem, s.
struct KnownBounds {
  double fastest = 0.0;             ///< each arm's fastest motion on its own
  double monotone = 0.0;            ///< pairs of motions that never turn back; 0 if not known
  PassageProof demanded;            ///< the passage bound at the demanded clearance
  PassageProof planned;             ///< and at that which plans are made with
  std::optional<VisitBound> visit;  ///< moving objects, at the demanded clearance
  double planned_visit = 0.0;       ///< and at that which plans are made with

  /// The largest of those that hold for every plan, s.
  double of_every_plan() const;
};

/// The arms on their own, and the ways there are for them around each other.
struct Passages {
  Travellers travellers;  ///< refer to the prepared problem's systems
  PassageBound bound;     ///< at the planning clearance
};

/// What one planning run has found out so far. The observer outlives it.
class Findings {
 public:
  explicit Findings(const Observer& observer) : observer_(observer) {}

  KnownBounds bounds;
  std::optional<Passages> passages;        ///< where they were looked for
  std::optional<KnownSchedule> analytic;   ///< of the plan that the analytic methods gave
  std::optional<IntervalSet> safe_delays;  ///< s, of the fastest motions; moving objects left out
  std::vector<std::string> tried;          ///< one line a method that did not lead to a plan
  Statistics statistics;
  std::string remedy =
      "No plan was found and none is excluded; allow more methods or a larger planning budget, or try another seed.";

  /// Tells the observer what is being done.
  void begin(std::string_view phase);

  /// Tells the observer of a verified plan.
  void found(const Plan& plan) const;

  /// Whether somebody wants to know plans before the last one.
  bool are_plans_awaited() const { return static_cast<bool>(observer_.on_incumbent); }

  /// Of the planning run as it stands.
  PlanningStatus status() const;
  Undecided undecided(double seconds_spent) const;

 private:
  const Observer& observer_;
  std::string_view phase_;
};

}  // namespace dualarm
