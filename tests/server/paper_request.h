#pragma once

#include "server/wire.h"

namespace dualarm {

/// A sound request: the paper's two arms (l = 6 m, L = 8 m, r = 1e-9 m, m = 1 kg, J = 3 kg m2, 60 N m, 2 rad/s), arm
/// "left" from 20 to 60 degrees and arm "right" from 70 to 20. Theory, section 4.
wire::PlanMotionRequest paper_request();

/// The same robot and tasks with made-up trajectories of two knots each, at rest.
wire::VerifyMotionRequest paper_verify_request();

}  // namespace dualarm
