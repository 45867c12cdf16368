#pragma once

#include <array>

#include "core/phase_plane/system.h"

namespace dualarm {

/// Position and velocity as Boost.Odeint takes them.
using PlaneState = std::array<double, 2>;

/// What Odeint integrates along an extremal arc, with positions from `origin` (rad) on. Refers to the system.
inline auto extremal_rate(const System& system, Extreme extreme, double origin = 0.0) {
  return [&system, extreme, origin](const PlaneState& state, PlaneState& rate, double /*time*/) {
    rate = {state[1], system.extreme_acceleration(extreme, origin + state[0], state[1])};
  };
}

}  // namespace dualarm
