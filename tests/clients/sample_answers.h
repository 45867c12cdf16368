// Answers made by hand, for the tests of what renders them.
#pragma once

#include "dualarm/planning/v1/planning_service.pb.h"

namespace dualarm {

/// Arms "left" and "<right>"; left goes from 0.5 to 1 rad, <right> from 2 to 1 rad.
planning::v1::PlanMotionRequest sample_request();

/// A delay plan of 3 s for it: <right> moves at once, for 2 s; left waits 1 s, then moves for 2 s.
planning::v1::PlanMotionResponse sample_plan();

planning::v1::PlanMotionResponse sample_infeasible();

/// A square from 0.2 to 0.4 rad in both directions, in joint ranges from 0 to pi.
planning::v1::GetForbiddenRegionResponse sample_region();

}  // namespace dualarm
