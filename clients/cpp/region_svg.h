// The paper's figure 2.
#pragma once

#include <string>
#include <vector>

#include "clients/cpp/region_sets.h"

namespace dualarm {

/// An SVG document: joint positions as axes in degrees, the sets in the order given (the largest first) upon each
/// other, a legend with their names, and a note of what is left out. At least one set.
std::string region_svg(const std::string& name, const planning::v1::PlanMotionRequest& scenario,
                       const std::vector<RegionSet>& sets);

}  // namespace dualarm
