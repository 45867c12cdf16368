#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/verification/interpolant.h"
#include "core/verification/verify.h"

namespace dualarm {

struct ClearanceReport {
  bool collision_free = false;
  double min_clearance = 0.0;  ///< m, proven lower bound if collision_free, else the smallest that was seen
  std::optional<ClosestApproach> closest;
  int distance_query_count = 0;
  std::vector<Violation> violations;  ///< kClearance, one for each colliding pair seen, or one kClearanceUnknown
};

/// Proves or refutes the demanded clearance of all pairs of bodies from time 0 to `duration`: the bodies that move with
/// one arm against those of the other, and against those that stand still or move by themselves, at their own times.
/// An arm that is at rest at the end stays there: what moves by itself may not come too close to it later either.
/// Bodies of one arm are rigidly connected, and objects in the world may overlap each other, so these are not compared
/// among themselves. Bodies that touch collide, also where 0 is demanded.
///
/// Best first: each interval of time of each pair has a proven lower bound on its distance (the better of a speed bound
/// and separation). A look at the one with the lowest bound proves a stretch around its middle to be far enough; what
/// is before and after that stretch is left (both halves where it is none, or both sides of a corner of a track), until
/// the lowest bound is as good as the smallest distance that FCL has seen. Theory, section 5.
ClearanceReport check_clearance(const Problem& problem, const std::array<Interpolant, kArmCount>& motions,
                                double duration, const Budget& budget);

}  // namespace dualarm
