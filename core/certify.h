#pragma once

#include "core/findings.h"
#include "core/plan.h"

namespace dualarm {

/// A duration this close to a bound, relative, is at it: rounding of quadratures and sums.
inline constexpr double kAtBound = 1e-9;

/// How good a plan of a duration (s) is; its safe start delays are not filled in. Throws std::logic_error where a bound
/// contradicts the plan. Theory, section 4.
Certificate certify(double duration, const KnownBounds& known);

}  // namespace dualarm
