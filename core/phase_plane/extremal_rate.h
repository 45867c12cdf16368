#pragma once

#include <array>

#include "core/phase_plane/system.h"

namespace dualarm {

/// Position and velocity as Boost.Odeint takes them.
using PlaneState = std::array<double, 2>;

/// What Odeint integrates along an extremal arc. Refers to the system.
inline auto extremal_rate(const System& system, Extreme extreme) {
  return [&system, extreme](const PlaneState& state, PlaneState& rate, double /*time*/) {
    rate = {state[1], system.extreme_acceleration(extreme, state[0], state[1])};
  };
}

}  // namespace dualarm
