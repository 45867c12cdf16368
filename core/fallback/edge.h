#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/fallback/clearance_proof.h"
#include "core/fallback/profile_table.h"
#include "core/fallback/steering.h"

namespace dualarm {

/// For each arm its motions, in order of time, resting in between.
using Schedule = std::array<std::vector<TimedProfile>, kArmCount>;

/// What one arm does during an edge: it holds, then moves towards a state for some time. Its fastest motion there is
/// cut short if that takes longer, and slowed down if the arm arrives in motion and that takes less.
struct Move {
  double wait = 0.0;  ///< s
  JointState target;
  double lasts = 0.0;  ///< s
};

/// What both arms do from one node to the next.
struct Edge {
  std::array<Move, kArmCount> moves;
  JointStates end;
  double duration = 0.0;  ///< s
};

/// The motions of a move from a state, one or two; the same state and move give the same motions. Nothing where there
/// are none.
std::optional<std::vector<Profile>> motions_of(const System& system, JointState from, const Move& move,
                                               const Budget& budget = Budget());

/// Both arms on their way from states at a time to targets, by the fastest motion of each: edges differ by when the
/// arms begin and where they end.
class Attempt {
 public:
  /// `time` s since the start of the plan. The proof and the systems outlive it.
  Attempt(const Systems& systems, const ClearanceProof& proof, const JointStates& from, double time,
          const JointStates& targets);

  /// Whether each arm has a motion.
  bool is_possible() const { return motions_[0] && motions_[1]; }

  double duration(int arm) const { return durations_[arm]; }  ///< s, of an arm's motion
  bool can_wait(int arm) const { return can_wait_[arm]; }     ///< before its motion
  bool can_stay(int arm) const { return can_stay_[arm]; }     ///< after it

  /// Slows an arm's motion down to a duration (s). False, and nothing changes, where it cannot be that slow.
  bool stretch(int arm, double duration);

  /// The edge on which the arms wait for some times (s) and that ends after `duration` (s), if it is proven to keep the
  /// clearance. An arm that arrives before has to stay, one that does not is cut short. Nothing where an arm cannot do
  /// so, or where there is no proof.
  std::optional<Edge> edge(const JointPair& waits, double duration) const;

 private:
  bool can_do(int arm, double wait, double duration) const;

  const Systems* systems_;
  const ClearanceProof* proof_;
  JointStates from_;
  double time_;
  JointStates targets_;
  std::array<std::optional<std::vector<Profile>>, kArmCount> motions_;
  std::array<std::vector<ProfileTable>, kArmCount> tables_;
  JointPair durations_ = {};
  std::array<bool, kArmCount> can_wait_;
  std::array<bool, kArmCount> can_stay_;
};

/// An edge from states in a time (s since the start of the plan) to others, both arms there at its end: each begins at
/// once or as late as it can, and is slowed down where it can do neither. Nothing where none is proven.
std::optional<Edge> connect(const Systems& systems, const ClearanceProof& proof, const JointStates& from,
                            const JointStates& to, Interval time);

}  // namespace dualarm
