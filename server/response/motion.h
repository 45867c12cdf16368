#pragma once

#include "core/plan.h"
#include "server/wire.h"

namespace dualarm {

/// What plans and phase portraits say of a motion.
wire::Arc arc_message(const Arc& arc);
wire::Claim claim_message(Claim claim);

}  // namespace dualarm
