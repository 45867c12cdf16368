#pragma once

#include "core/plan.h"
#include "server/wire.h"

namespace dualarm {

wire::Plan plan_message(const Plan& plan);

}  // namespace dualarm
