#pragma once

#include "geometry/body.h"

namespace dualarm {

/// Distance (m) of two capsules, negative on overlap as for FCL (distance of the axes minus both radii): a second route
/// in long double, by cases (an end against the other axis, four times; both interiors) instead of by clamping.
long double exact_distance(const Capsule& first, const Capsule& second);

}  // namespace dualarm
