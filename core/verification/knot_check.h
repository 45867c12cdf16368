#pragma once

#include <vector>

#include "core/verification/verify.h"

namespace dualarm {

/// Whether the knots describe motions at all: one trajectory for each arm in the problem's order, at least two knots,
/// all numbers finite, times from 0 that do not decrease to one end for both arms, no jump of position or velocity.
/// Kinds: kArm, kKnotOrder, kContinuity. What fails here can not be judged further.
std::vector<Violation> check_knots(const Problem& problem, const Trajectory& trajectory);

/// Whether each motion begins and ends as its task says. Kind: kEndState.
std::vector<Violation> check_end_states(const Problem& problem, const Trajectory& trajectory);

}  // namespace dualarm
