#pragma once

#include <variant>

#include "core/model/budget.h"
#include "core/model/problem.h"
#include "core/phase_plane/profile.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// Over which motions a fastest motion is the minimum. Theory, sections 1.1 to 1.3.
enum class MinimumOver {
  kAllMotions,       ///< proven: no motion of any kind is faster
  kMonotoneMotions,  ///< none that never turns back is faster, and none that does was found, if they were searched
  kSearchedMotions,  ///< none is faster among the motions with turning points that were searched
};

struct FastestMotion {
  Profile profile;
  MinimumOver minimum_over = MinimumOver::kAllMotions;
  double lower_bound = 0.0;  ///< s, below which no motion of any kind gets there: the profile's duration if it is the
                             ///< minimum over all
};

/// Why no motion exists, or none was found.
enum class BlockReason {
  kStartOutsideRange,
  kGoalOutsideRange,
  kStartNotHoldable,  ///< at rest at the start, and zero acceleration is not admissible there
  kGoalNotHoldable,   ///< at rest at the goal, and zero acceleration is not admissible there
  kStartTooFast,   ///< full braking from the start ends beyond the joint range, or the start breaks the velocity limit
  kGoalTooFast,    ///< no run-up inside the joint range is long enough, or the goal breaks the velocity limit
  kVelocityLimit,  ///< even with full braking the velocity limit is broken on the way
  kStalls,         ///< even with full acceleration the motion comes to rest before the goal
  kCannotBrake,    ///< even with full braking the motion is driven past the goal
};

struct Blocked {
  BlockReason reason = BlockReason::kStalls;
  double position = 0.0;                ///< rad, where
  double velocity = 0.0;                ///< rad/s, with which it gets there or would have to
  Extreme extreme = Extreme::kHighest;  ///< the end of the admissible accelerations that falls short there
  bool is_proven = true;                ///< no motion of any kind exists; false if one that turns back might
  double lower_bound = 0.0;             ///< s, below which no motion of any kind gets there, if one exists
  bool is_searched_out = true;          ///< false if the budget ended the search for motions that turn back
};

/// Whether motions that swing to and fro are searched where they might be faster, or the only ones. It costs
/// milliseconds instead of microseconds.
enum class Swings { kSearch, kSkip };

/// The fastest motion from `start` to `goal`, with any velocities, under the system's limits: full acceleration, cruise
/// on the velocity limit where the acceleration needed is admissible, full braking, with turning points where the
/// boundary velocities ask for them or where swinging pays. It stands still before a start at rest and after a goal at
/// rest, so it has to be holdable there. When the budget runs out, the search for swings ends with the fastest motion
/// found by then; no other answer changes. Theory, sections 1.1 to 1.3 [paper, section 3].
std::variant<FastestMotion, Blocked> fastest_motion(const System& system, JointState start, JointState goal,
                                                    Swings swings = Swings::kSearch, const Budget& budget = Budget());

/// The duration (s) of what fastest_motion answers with Swings::kSkip, to 1e-12, without its profile and its claim and
/// in half the time; infinite where it is blocked.
double fastest_duration(const System& system, JointState start, JointState goal);

/// The fastest motion from rest to rest.
inline std::variant<FastestMotion, Blocked> fastest_motion(const System& system, double start, double goal,
                                                           Swings swings = Swings::kSearch,
                                                           const Budget& budget = Budget()) {
  return fastest_motion(system, JointState{start, 0.0}, JointState{goal, 0.0}, swings, budget);
}

}  // namespace dualarm
