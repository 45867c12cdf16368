#pragma once

#include <functional>

#include "core/fallback/alignment.h"
#include "core/fallback/clearance_proof.h"
#include "core/fallback/itinerary.h"
#include "core/fallback/random.h"
#include "core/model/budget.h"

namespace dualarm {

/// Makes a plan shorter by trial: drops, moves and adds the states that legs lead through, at rest or in motion,
/// changes waits, and lets one arm begin at once and the other end as early as can be proven. Every plan it takes is
/// proven free and shorter than the one before, or no longer and with less waiting between legs.
class Refinement {
 public:
  /// `first` is proven free. The other objects outlive it.
  Refinement(const Systems& systems, const ClearanceProof& proof, Itinerary first, const PlanRules& rules,
             Random& random, const Budget& budget);

  /// Tries until `evaluation_limit` plans have been tried in all, the lower bound is reached or the budget is
  /// exhausted. `on_better` is told after each step that made the plan shorter.
  void run(int evaluation_limit, const std::function<void()>& on_better = {});

  const Itinerary& best() const { return best_; }
  double duration() const { return duration_; }                            ///< s, of the best
  int evaluations() const { return changes_ + alignment_.evaluations(); }  ///< changes made and proofs tried

 private:
  Itinerary changed();
  void change_once(Itinerary& candidate);
  void insert(Itinerary& candidate, int arm, int leg);
  void move(Itinerary& candidate);
  JointState beside(int arm, JointState state);
  void consider(const Itinerary& candidate);
  bool improves_aligned(const Itinerary& candidate);
  void keep_if_faster(Itinerary candidate);
  void take(Itinerary shorter);

  const Systems& systems_;
  Alignment alignment_;
  bool has_movers_;  ///< objects that move by themselves
  Itinerary best_;
  double duration_;
  double waits_;
  double lower_bound_;
  Random& random_;
  const Budget& budget_;
  int leader_ = 0;  ///< who began first in the last plan that was taken
  int changes_ = 0;
};

}  // namespace dualarm
