#pragma once

#include "core/arm_portrait.h"
#include "server/wire.h"

namespace dualarm {

wire::GetPhasePortraitResponse portrait_message(const ArmPortrait& portrait);

}  // namespace dualarm
