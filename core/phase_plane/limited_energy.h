#pragma once

#include <optional>

#include "core/model/problem.h"
#include "core/phase_plane/path.h"

namespace dualarm {

/// Where a motion would have to break the velocity limit, because it can get past a place in no other way.
struct LimitBreak {
  double position = 0.0;                ///< rad
  double velocity = 0.0;                ///< rad/s, the limit in the direction of motion
  ArcKind kind = ArcKind::kAccelerate;  ///< driving that carries no motion from the limit past what follows, or braking
                                        ///< that holds no motion at the limit after what comes before
};

/// The proof that no motion gets from one position past all those up to another under a velocity limit, wherever it
/// turns round in the range: the energy that driving gives at most, from rest at the range's end or from the start, and
/// never more than the limit's, runs out on the way; or, the same backwards in time, the energy that braking takes at
/// most. Nothing where neither is shown, or where no limit plays a part. Theory, section 1.3.
std::optional<LimitBreak> limit_break(const System& system, JointState start, JointState goal);

}  // namespace dualarm
