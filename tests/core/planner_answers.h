#pragma once

#include <Eigen/Core>
#include <string>

#include "core/model/problem.h"
#include "core/plan.h"

namespace dualarm {

/// The plan for a problem, expected to hold by its verification and by the check that shares nothing with the planner
/// or its verifier; an empty one, and a failure that says why, where there is none.
Plan must_plan(const Problem& problem);

/// The refusal of a problem, expected to have words; an empty one and a failure where it is not refused.
Infeasible must_refuse(const Problem& problem);

/// A sphere (m) that stands in the world.
Object ball(const std::string& name, const Eigen::Vector3d& at, double radius);

}  // namespace dualarm
