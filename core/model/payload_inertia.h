#pragma once

#include "geometry/body.h"

namespace dualarm {

/// Moment of inertia (kg m2) of a mass (kg) spread evenly over a shape in the link frame, about the joint's axis, the z
/// axis. A shape without volume has its mass spread evenly over what it is: a plate, a segment or a point.
double payload_inertia(const Shape& in_link, double mass);

}  // namespace dualarm
