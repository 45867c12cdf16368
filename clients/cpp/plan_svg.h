// A plan in the plane of the joint positions: the paper's figure 2 with the path through it.
#pragma once

#include <string>

#include "dualarm/planning/v1/planning_service.pb.h"

namespace dualarm {

/// The question whose answer `plan_svg` draws behind the path of `request`.
planning::v1::GetForbiddenRegionRequest region_request_for(const planning::v1::PlanMotionRequest& request);

/// An SVG document: joint ranges as axes in degrees, the forbidden set, the path with a dot at equal steps of time,
/// start and goal of the tasks, a legend. Without a plan in `response` there is no path and the title says why.
std::string plan_svg(const std::string& name, const planning::v1::PlanMotionRequest& request,
                     const planning::v1::PlanMotionResponse& response,
                     const planning::v1::GetForbiddenRegionResponse& region);

}  // namespace dualarm
