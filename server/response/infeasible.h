#pragma once

#include "core/plan.h"
#include "server/wire.h"

namespace dualarm {

wire::Infeasible infeasible_message(const Infeasible& infeasible);

}  // namespace dualarm
