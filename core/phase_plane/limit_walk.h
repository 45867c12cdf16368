#pragma once

#include "core/phase_plane/path.h"

namespace dualarm {

/// How far a motion on the velocity limit can follow it from `x` on: to where even full drive falls below it, or to the
/// end of the path.
double held_forward(const Path& path, double x, double until);

/// How far back from `x` the velocity limit can be held by braking: to where even full braking overspeeds, or to 0. At
/// least one step back, where braking holds it at all by less than shows.
double held_backward(const Path& path, double x);

}  // namespace dualarm
