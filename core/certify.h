#pragma once

#include "core/passage/proof.h"
#include "core/plan.h"

namespace dualarm {

/// A duration this close to a bound, relative, is at it: rounding of quadratures and sums.
inline constexpr double kAtBound = 1e-9;

/// What is known of the durations of all plans of a problem, s.
struct KnownBounds {
  double fastest = 0.0;   ///< each arm's fastest motion on its own
  double monotone = 0.0;  ///< pairs of motions that never turn back; 0 if not known
  PassageProof demanded;  ///< the passage bound at the demanded clearance
  PassageProof planned;   ///< and at that which plans are made with
};

/// How good a plan of a duration (s) is; its safe start delays are not filled in. Theory, section 4.
Certificate certify(double duration, const KnownBounds& known);

}  // namespace dualarm
