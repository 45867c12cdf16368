#pragma once

#include "core/fallback/itinerary.h"

namespace dualarm {

/// Adds an arm's fastest motion from rest to rest (rad) at a time (s); returns its duration (s).
inline double append_leg(Itinerary& itinerary, const Systems& systems, int arm, double time, double from, double to) {
  const auto motion = steer(*systems[arm], {from, 0.0}, {to, 0.0});
  itinerary.append(arm, time, motion.value(), {to, 0.0});
  return motion->duration();
}

}  // namespace dualarm
