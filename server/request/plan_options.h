#pragma once

#include <array>
#include <chrono>
#include <optional>

#include "core/model/problem.h"
#include "server/request/field.h"
#include "server/wire.h"

namespace dualarm {

/// Options of a plan; an absent message means every default. What is wrong is noted on `options`.
PlanOptions read_plan_options(const wire::PlanOptions& message, const Field& options);

/// The planning budget asked for; nothing if none is.
std::optional<std::chrono::nanoseconds> read_planning_budget(const wire::PlanOptions& message, const Field& options);

/// A region model, which is the field `region_model` of `field`; the paper's asks for the paper's mounting of the arms.
RegionModel read_region_model(wire::RegionModel model, const Field& field, const std::array<Arm, kArmCount>& arms);

}  // namespace dualarm
