#pragma once

#include <vector>

#include "core/verification/interpolant.h"
#include "core/verification/verify.h"

namespace dualarm {

/// Whether what an arm's trajectory says besides its knots tells the same motion: arcs that follow each other from 0
/// to the end of the plan and pass through the knots' states, arcs of rest and of constant velocity that are, rest
/// before the start time and after the duration. A trajectory without arcs and duration says nothing. Kind: kArc.
std::vector<Violation> check_arcs(const ArmTrajectory& trajectory, const Interpolant& motion);

}  // namespace dualarm
