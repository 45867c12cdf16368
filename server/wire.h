#pragma once

#include "dualarm/planning/v1/planning_service.pb.h"

namespace dualarm {

/// The messages of proto/dualarm/planning/v1; `Arm` is the planner's, `wire::Arm` is the message.
namespace wire = ::dualarm::planning::v1;

}  // namespace dualarm
