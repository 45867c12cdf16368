#pragma once

#include <array>
#include <vector>

#include "core/fallback/profile_table.h"
#include "core/fallback/steering.h"
#include "core/model/problem.h"
#include "geometry/body.h"

namespace dualarm {

/// A motion of one arm and when it begins (s).
struct TimedTable {
  double start_time = 0.0;
  const ProfileTable* table = nullptr;  ///< not owned; a proof lasts no longer than whoever asks for it
};

/// What an arm does: motions in order of time, at least one, not overlapping, resting in between.
using Track = std::vector<TimedTable>;

/// Where the two arms are free of each other and of the fixed bodies, and which motions provably are. Theory,
/// section 5.
class ClearanceProof {
 public:
  /// `clearance` (m): what all bodies have to keep.
  ClearanceProof(const Problem& problem, double clearance);

  /// Lower bound (m) on what is left of the closest pair's distance beyond the demanded clearance; negative where it is
  /// missed.
  double slack(const JointPair& positions) const;

  /// True if the whole of both tracks, from before the first motion to after the last, is proven to keep the clearance
  /// by the bound on how fast a distance can change. False where it does not, or comes too close for a proof.
  bool proves(const std::array<Track, kArmCount>& tracks) const;

 private:
  struct Span;

  /// Largest way (m) that any point of a moving body can have moved against any other body, when the joints changed
  /// monotonely from one pair of positions to the other.
  double largest_approach(const JointPair& from, const JointPair& to) const;

  std::array<Base, kArmCount> bases_;
  std::array<std::vector<Body>, kArmCount> moving_;
  std::array<double, kArmCount> reach_;
  std::vector<Body> fixed_;
  double clearance_;
};

}  // namespace dualarm
