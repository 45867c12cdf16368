#pragma once

#include <array>

#include "core/fallback/itinerary.h"
#include "core/model/problem.h"

namespace dualarm {

/// Smallest gap (m) between the two links and between links and balls that stand
/// or move by themselves, at `count` evenly spaced instants from 0
/// to `duration`. Own plane geometry and own interpolation between states of the exact motions.
double smallest_gap(const Problem& problem, const Schedule& schedule, double duration, int count);

/// Expects times in order, rests that meet, starts and goals of the problem, the duration told, positions in range.
void expect_consistent(const Problem& problem, const Schedule& schedule, double duration);

}  // namespace dualarm
