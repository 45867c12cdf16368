#pragma once

#include "geometry/body.h"

namespace dualarm {

/// Largest distance (m) of any point of a body in the link frame from the joint's axis. A joint change of d rad moves
/// no point of the body by more than reach * |d| (theory, section 5).
double reach(const Capsule& in_link_frame);

}  // namespace dualarm
