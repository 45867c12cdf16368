#pragma once

#include <optional>

#include "core/model/budget.h"
#include "core/model/problem.h"

namespace dualarm {

/// A duration below which no plan can be, because an object that moves by itself is in an arm's way.
struct TrafficProof {
  double duration = 0.0;  ///< s
  int arm = 0;
  double position = 0.0;  ///< rad, between its start and its goal
  double until = 0.0;     ///< s since the start of the plan: until then the object is there
};

/// What moving objects demand of the arms' durations, at a `clearance` (m). In the plane of an arm's position and time
/// an object is an obstacle, and a motion a curve that rises past it, on the one side or the other all along. Where the
/// arm comes too late for any point of it, it passes behind all of it: at each of its positions after it has gone, and
/// from there the arm still has to get to the goal. The slowest found, of objects that do not turn, for arms that rest
/// at their goals; nothing where none is slower than `known` (s), or the budget ran out. Proven for motions of all
/// kinds of at most `longest` (s), of relaxed arms where need be (relaxed_arm.h). Theory, section 4.
std::optional<TrafficProof> traffic_proof(const Problem& problem, double clearance, double known, double longest,
                                          const Budget& budget);

}  // namespace dualarm
