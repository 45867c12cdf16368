#pragma once

#include "core/fallback/clearance_proof.h"
#include "core/fallback/itinerary.h"
#include "core/fallback/random.h"
#include "core/model/budget.h"

namespace dualarm {

/// Makes a plan of legs and rests shorter by trial: drops rests and waits, moves and adds rests, and lets one arm begin
/// at once and the other end as early as can be proven. Every plan it takes is proven free and shorter than the one
/// before, or no longer and with less waiting between legs.
class Refinement {
 public:
  /// `first` is proven free; `lower_bound` s: no plan is shorter. The other objects outlive it.
  Refinement(const Systems& systems, const ClearanceProof& proof, Itinerary first, double lower_bound, Random& random,
             const Budget& budget);

  /// Tries until `evaluation_limit` plans have been tried in all, the lower bound is reached or the budget is
  /// exhausted.
  void run(int evaluation_limit);

  const Itinerary& best() const { return best_; }
  int evaluations() const { return evaluations_; }  ///< changes made and proofs tried

 private:
  Itinerary changed();
  void change_once(Itinerary& candidate);
  void consider(const Itinerary& candidate);
  bool improves_aligned(Itinerary candidate);
  void keep_if_faster(const Itinerary& candidate);
  bool proven(Itinerary& candidate, int leader, double end);
  bool proves_for_good(const Itinerary& candidate, double end) const;  ///< until no object moves any more

  const Systems& systems_;
  const ClearanceProof& proof_;
  Itinerary best_;
  double duration_;
  double waits_;
  double lower_bound_;
  Random& random_;
  const Budget& budget_;
  int leader_ = 0;  ///< who began first in the last plan that was taken
  int evaluations_ = 0;
};

}  // namespace dualarm
