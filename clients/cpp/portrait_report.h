// A phase portrait for people.
#pragma once

#include <string>

#include "dualarm/planning/v1/planning_service.pb.h"

namespace dualarm {

/// Duration, claim, arcs and switch points of the fastest motion, or why there is none, in lines. `name` is what people
/// call the request.
std::string portrait_report(const std::string& name, const std::string& arm,
                            const planning::v1::GetPhasePortraitResponse& response);

/// One plain sentence on what is claimed of the motion's duration.
std::string claim_sentence(const planning::v1::GetPhasePortraitResponse& response);

}  // namespace dualarm
