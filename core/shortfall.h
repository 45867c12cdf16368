#pragma once

#include <optional>

#include "core/model/arm.h"
#include "core/model/budget.h"
#include "core/model/problem.h"

namespace dualarm {

/// A limit of an arm that can be widened: by N m and rad/s at both ends, by rad at one end of the joint range. A
/// torque-speed line gets more torque at standstill, a table more in every entry.
enum class WidenedLimit { kTorque, kVelocity, kRangeBelow, kRangeAbove };

/// An arm with a limit wider by `amount` >= 0, in the limit's unit.
Arm with_wider(const Arm& arm, WidenedLimit limit, double amount);

/// By how much a limit has to be wider for an arm that no motion takes from start to goal: with a thousandth more a
/// motion is found, with a thousandth less there is proven to be none. `arm` with all it carries, its joint range as
/// free as it is. `guess` (> 0), where it is known, is the answer if it is right; else the amount is halved down to.
/// Nothing where proof and search do not meet, where no amount is enough or any is, on tables of more than a thousand
/// entries, or where the budget runs out. Some dozens of fastest motions.
std::optional<double> shortfall(const Arm& arm, const Task& task, WidenedLimit limit, std::optional<double> guess,
                                const Budget& budget);

}  // namespace dualarm
