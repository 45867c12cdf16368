// A drawing of a phase portrait: figures 3 and 4 of the paper.
#pragma once

#include <string>

#include "dualarm/planning/v1/planning_service.pb.h"

namespace dualarm {

/// An SVG document: position in degrees to the right, velocity in rad/s upwards; both limit curves, the switching curve
/// of the goal, the fastest motion with its arcs coloured by their kind, start and goal. It shows
/// everything, or where that is far larger than the motion only the motion's neighbourhood. `name` is what people call
/// the request.
std::string portrait_svg(const std::string& name, const planning::v1::ArmTask& task,
                         const planning::v1::GetPhasePortraitResponse& response);

}  // namespace dualarm
