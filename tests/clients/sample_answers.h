// Answers made by hand, for the tests of what renders them.
#pragma once

#include "dualarm/planning/v1/planning_service.pb.h"

namespace dualarm {

/// Arms "left" and "<right>"; left goes from 0.5 to 1 rad, <right> from 2 to 1 rad.
planning::v1::PlanMotionRequest sample_request();

/// A delay plan of 3 s for it: <right> moves at once, for 2 s; left waits 1 s, then moves for 2 s.
planning::v1::PlanMotionResponse sample_plan();

planning::v1::PlanMotionResponse sample_infeasible();

/// The portrait of left's motion: it accelerates for 1 s to 0.75 rad and 0.5 rad/s and brakes for 1 s; limits of
/// 0.8 rad/s over [0, 1.25] rad, the upper one with a gap over (0.5, 1), and both branches of the switching curve.
planning::v1::GetPhasePortraitResponse sample_portrait();

/// A square from 0.2 to 0.4 rad in both directions, in joint ranges from 0 to pi.
planning::v1::GetForbiddenRegionResponse sample_region();

}  // namespace dualarm
