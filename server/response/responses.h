#pragma once

#include <vector>

#include "core/arm_portrait.h"
#include "core/coordination/region.h"
#include "core/plan.h"
#include "server/wire.h"

namespace dualarm {

/// What the planner answered, in the words of the wire.
wire::PlanMotionResponse response_message(const Outcome& outcome);
wire::VerifyMotionResponse response_message(const Verification& verification);
wire::GetForbiddenRegionResponse response_message(const std::vector<Contour>& contours, const Problem& problem);
wire::GetPhasePortraitResponse response_message(const ArmPortrait& portrait);

}  // namespace dualarm
