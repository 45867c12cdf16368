#pragma once

#include "geometry/body.h"
#include "geometry/chain.h"

namespace dualarm {

/// Largest distance (m) of any point of a body in the link frame from the joint's axis, the z axis. A joint change of
/// d rad moves no point of the body by more than reach * |d| (theory, section 5). Of a cylinder that leans an upper
/// bound, exact where its axis is parallel to the joint's or at right angles to it.
double reach(const Shape& in_link_frame);

/// Largest distance (m) of any point of a body from the origin of its frame. However the frame turns, at w rad/s no
/// point moves faster than extent * w relative to the origin.
double extent(const Shape& in_its_frame);

/// Lower bound (m, perhaps negative) on the distance of a body that stands in the world from one in the link frame,
/// wherever the joint is: that of the ball around the one from the disc that holds all that the other sweeps. In some
/// nanoseconds.
double swept_gap(const Base& base, const Shape& in_link_frame, const Shape& standing);

}  // namespace dualarm
