// What PlanMotionStream tells on the way, as lines for people.
#pragma once

#include <string>

#include "dualarm/planning/v1/planning_service.pb.h"

namespace dualarm {

/// One line, with its newline; "" for the outcome, which is a report of its own.
std::string progress_line(const planning::v1::PlanMotionStreamResponse& event);

}  // namespace dualarm
