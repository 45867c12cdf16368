#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/fallback/profile_table.h"
#include "core/fallback/steering.h"
#include "core/model/budget.h"
#include "core/model/problem.h"
#include "geometry/body.h"
#include "geometry/interval.h"

namespace dualarm {

/// A motion of one arm and when it begins (s since the start of the plan).
struct TimedTable {
  double start_time = 0.0;
  const ProfileTable* table = nullptr;  ///< not owned; a proof lasts no longer than whoever asks for it
};

/// What an arm does: motions in order of time, at least one, not overlapping, resting in between.
using Track = std::vector<TimedTable>;

/// Where the two arms are free of each other and of everything else, and which motions provably are. Theory, section 5.
class ClearanceProof {
 public:
  /// `clearance` (m): what all bodies have to keep. The problem, whose moving objects are looked at, outlives this, and
  /// so does the budget: when it runs out nothing is proven any more.
  ClearanceProof(const Problem& problem, double clearance, const Budget& budget);
  ClearanceProof(const Problem& problem, double clearance, const Budget&& budget) = delete;

  /// Lower bound (m) on what is left beyond the demanded clearance of the distance of the closest pair that may meet;
  /// negative where it is missed, infinite where no two may meet. Without the objects that move by themselves.
  double slack(const JointPair& positions) const;

  /// True if both tracks keep the clearance during a time (s) by the bound on how fast a distance can change; where a
  /// track has not begun or has ended its arm rests. False where they do not, or come too close for a proof.
  bool proves(const std::array<Track, kArmCount>& tracks, Interval time) const {
    return !where_unproven(tracks, time).has_value();
  }

  /// Nothing where the tracks are proven; otherwise a time (s) at which they collide or come too close, or the
  /// beginning if the budget ran out.
  std::optional<double> where_unproven(const std::array<Track, kArmCount>& tracks, Interval time) const;

  /// Whether two bodies miss the clearance at a time (s): much less work than a proof.
  bool collide_at(const std::array<Track, kArmCount>& tracks, double time) const;

  /// The time (s) from which on an arm may stand at a position (rad) for good as far as objects are concerned that move
  /// by themselves, not earlier than can be proven: minus infinity where none comes near, infinite where one comes to
  /// stay.
  double free_from(int arm, double position) const;

  /// What bounds its work, and that of whoever asks for it.
  const Budget& budget() const { return *budget_; }

  /// The time (s) from which on no object moves by itself; minus infinity where none ever does.
  double settled_time() const { return settled_time_; }

 private:
  /// A body and what carries it: an arm; a track; or nothing, and then it stands in the world.
  struct Mover {
    Shape shape;                       ///< in its carrier's frame
    Eigen::Vector3d centre;            ///< m, in its carrier's frame
    double radius = 0.0;               ///< m, of the ball around the centre
    double swing = 0.0;                ///< m, the most that a point of it moves for each rad its carrier turns
    int arm = -1;                      ///< -1: none
    const PoseTrack* track = nullptr;  ///< null: none
    Eigen::AlignedBox3d where = {};    ///< m, all that it may ever sweep
  };
  struct Pair {
    std::size_t first;   ///< of an arm; index into movers_
    std::size_t second;  ///< of the other arm, or of none
    double margin;       ///< m, what the distance that FCL finds has to exceed
  };
  struct Instant;
  struct Span;

  std::vector<Mover> movers_of(const Problem& problem) const;
  Eigen::Isometry3d pose(const Mover& mover, const Instant& instant) const;
  Eigen::Vector3d centre(const Mover& mover, const Instant& instant) const;
  Instant instant(const JointPair& positions, double time) const;
  double far_slack(const Pair& pair, const Instant& instant) const;
  double slack(const Pair& pair, const Instant& instant) const;
  double approach(const Pair& pair, const Instant& from, const Instant& to) const;
  std::optional<double> halve(std::vector<Span>& open, const std::array<Track, kArmCount>& tracks, int looks) const;
  double last_unproven(const Pair& pair, const Instant& from, const Instant& to) const;

  std::array<Base, kArmCount> bases_;
  std::vector<Mover> movers_;
  std::vector<Pair> pairs_;
  double settled_time_;
  const Budget* budget_;
};

}  // namespace dualarm
