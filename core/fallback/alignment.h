#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

#include "core/fallback/clearance_proof.h"
#include "core/fallback/itinerary.h"
#include "core/model/budget.h"

namespace dualarm {

/// What plans have to keep to, and where shortening them may stop.
struct PlanRules {
  double lower_bound = 0.0;                                          ///< s: no plan is shorter
  double max_start_delay = std::numeric_limits<double>::infinity();  ///< s, when an arm first moves at the latest
};

/// An itinerary that is proven free, and which arm begins at once in it.
struct Aligned {
  Itinerary itinerary;
  int leader = 0;
};

/// Gives itineraries start times that can be proven: one arm begins at once, the other one ends the plan. Remembers
/// where plans collided, because the next one may collide there, too.
class Alignment {
 public:
  /// All outlive it.
  Alignment(const ClearanceProof& proof, const PlanRules& rules, const Budget& budget)
      : proof_(proof), rules_(rules), budget_(budget) {}

  /// The itinerary with the earliest end (s) found by bisection up to `end`, with this leader or, where it is not
  /// proven to end by then, with the other one. Nothing where neither is.
  std::optional<Aligned> shortest(const Itinerary& itinerary, int leader, double end);

  /// Whether an itinerary is proven with its own waits and no longer than `end` (s); it is settled then.
  bool proves_as_is(Itinerary& itinerary, double end);

  int evaluations() const { return evaluations_; }  ///< proofs tried

 private:
  bool proves(Itinerary& itinerary, int leader, double end);
  bool proves_free(const Itinerary& itinerary);

  const ClearanceProof& proof_;
  PlanRules rules_;
  const Budget& budget_;
  int evaluations_ = 0;
  std::array<double, 4> collisions_ = {};  ///< s, of plans that were tried last
  std::size_t next_collision_ = 0;
};

}  // namespace dualarm
