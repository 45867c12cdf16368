// Many answers of the planner as a table, one row each.
#pragma once

#include <string>

#include "dualarm/planning/v1/planning_service.pb.h"

namespace dualarm {

/// Column titles and a rule: scenario, method, T1, T2, duration, lower bound, gap, clearance, time taken. T1 and T2 are
/// the arms' own moving times.
std::string table_header();

/// Where there is no plan the method column says so and the explanation follows.
std::string table_row(const std::string& name, const planning::v1::PlanMotionResponse& response);

/// For a request that got no answer.
std::string table_row(const std::string& name, const std::string& error);

}  // namespace dualarm
