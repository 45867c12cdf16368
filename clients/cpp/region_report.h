// Forbidden sets for people.
#pragma once

#include <string>
#include <vector>

#include "clients/cpp/region_sets.h"

namespace dualarm {

/// A row for each set: clearance, contours, area, what share of the joint rectangle that is, and its extent along both
/// joints; then what is left out. `name` is what people call the scenario.
std::string region_report(const std::string& name, const planning::v1::PlanMotionRequest& scenario,
                          const std::vector<RegionSet>& sets);

}  // namespace dualarm
