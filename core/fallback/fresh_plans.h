#pragma once

#include <functional>
#include <vector>

#include "core/fallback/alignment.h"
#include "core/fallback/random.h"

namespace dualarm {

/// Simple plans drawn at random: each arm goes straight to its goal, or by way of a state or two, and the one that goes
/// second as late as it has to. They differ in who goes first and in who steps aside, which no small change of a plan
/// does.
class FreshPlans {
 public:
  /// The itinerary in which both arms are in their start states. The other objects outlive this.
  FreshPlans(const Systems& systems, const ClearanceProof& proof, const Itinerary& start, const JointStates& goal,
             const PlanRules& rules, Random& random, const Budget& budget);

  /// Draws until `evaluation_limit` plans have been tried, one is as short as can be, or the budget is exhausted. Plans
  /// of `longest` (s) or more are of no use. `on_better` is told of each that is faster than all before.
  void run(int evaluation_limit, double longest, const std::function<void(const Itinerary&)>& on_better);

  /// The `count` fastest that differ, the fastest first.
  std::vector<Itinerary> best(std::size_t count) const;

  int evaluations() const { return drawn_ + alignment_.evaluations(); }  ///< plans drawn and proofs tried

 private:
  bool draw_legs(Itinerary& itinerary, int arm);
  JointState draw_via(int arm);

  const Systems& systems_;
  Itinerary start_;
  JointStates goals_;
  double lower_bound_;  ///< s: no plan is shorter
  Random& random_;
  const Budget& budget_;
  Alignment alignment_;
  std::vector<Itinerary> found_;  ///< the fastest first
  int drawn_ = 0;
};

}  // namespace dualarm
