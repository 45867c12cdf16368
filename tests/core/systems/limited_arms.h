#pragma once

#include "tests/core/systems/system_laws.h"

namespace dualarm {

/// Single-joint arms with every kind of torque limit, family by family.
std::vector<SystemFamily> arms_with_every_limit();

}  // namespace dualarm
