#pragma once

#include <variant>

#include "core/phase_plane/profile.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// Over which motions a fastest motion is the minimum. Theory, sections 1.1 and 1.3.
enum class MinimumOver {
  kAllMotions,       ///< actuators are strong: accelerations of both signs are admissible everywhere
  kMonotoneMotions,  ///< a motion that swings back first might be faster
};

struct FastestMotion {
  Profile profile;
  MinimumOver minimum_over = MinimumOver::kAllMotions;
  double lower_bound = 0.0;  ///< s, below which no motion of any kind gets there: the profile's duration if it is the
                             ///< minimum over all, else that of a double integrator with the range's best accelerations
};

/// Why no monotone motion from rest to rest exists.
enum class BlockReason {
  kStartOutsideRange,
  kGoalOutsideRange,
  kStartNotHoldable,  ///< zero acceleration is not admissible at the start
  kGoalNotHoldable,   ///< zero acceleration is not admissible at the goal
  kStalls,            ///< even with full acceleration the motion comes to rest before the goal
  kCannotBrake,       ///< even with full braking the motion is driven past the goal
};

struct Blocked {
  BlockReason reason = BlockReason::kStalls;
  double position = 0.0;                ///< rad, where
  Extreme extreme = Extreme::kHighest;  ///< the end of the admissible accelerations that falls short there
  bool is_proven = true;                ///< no motion of any kind exists; false if swinging back first might help
  double lower_bound = 0.0;             ///< s, below which no motion of any kind gets there, if one exists
};

/// The fastest monotone motion from rest at `start` to rest at `goal` under the system's limits: full acceleration,
/// cruise on the velocity limit where the acceleration needed is admissible, full braking, with switches by work and
/// energy. Theory, section 1.1 [paper, section 3].
std::variant<FastestMotion, Blocked> fastest_motion(const System& system, double start, double goal);

}  // namespace dualarm
