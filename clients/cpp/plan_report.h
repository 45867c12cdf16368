// One answer of the planner, for people.
#pragma once

#include <string>

#include "dualarm/planning/v1/planning_service.pb.h"

namespace dualarm {

/// Headline, then lines with a label column. `name` is what the request is called, such as its file.
std::string plan_report(const std::string& name, const planning::v1::PlanMotionResponse& response);

}  // namespace dualarm
