#pragma once

#include "core/plan.h"
#include "server/wire.h"

namespace dualarm {

wire::Undecided undecided_message(const Undecided& undecided);

}  // namespace dualarm
