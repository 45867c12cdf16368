#pragma once

#include <array>
#include <vector>

#include "core/model/problem.h"
#include "server/request/field.h"
#include "server/wire.h"

namespace dualarm {

/// The objects of a scene; an absent scene is an empty message. What is wrong is noted on `scene`.
std::vector<Object> read_scene(const wire::Scene& message, const Field& scene, const std::array<Arm, kArmCount>& arms);

}  // namespace dualarm
