#pragma once

#include "core/verification/verify.h"
#include "server/wire.h"

namespace dualarm {

wire::Verification verification_message(const Verification& verification);

}  // namespace dualarm
