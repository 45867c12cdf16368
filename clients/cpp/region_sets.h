// The forbidden sets that one picture compares.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "dualarm/planning/v1/planning_service.pb.h"

namespace dualarm {

/// One set of the plane of the joint positions.
struct RegionSet {
  std::string name;  ///< "exact set", "paper's set", with ", with margin" where a clearance counts
  double clearance_m = 0.0;
  bool is_paper = false;
  planning::v1::GetForbiddenRegionResponse region;
};

/// What of a scenario is asked; `resolution` 0 is the server's choice.
planning::v1::GetForbiddenRegionRequest region_request(const planning::v1::PlanMotionRequest& scenario,
                                                       planning::v1::RegionModel model, double clearance_m,
                                                       int resolution);

using RegionCall =
    std::function<planning::v1::GetForbiddenRegionResponse(const planning::v1::GetForbiddenRegionRequest&)>;

/// The exact set and, where the arms are mounted as the paper's are, the paper's set; each once as it is and once with
/// the scenario's clearance, if it demands one: the paper's figure 2 and its safety region. The paper's set of the wire
/// holds the exact one. The largest comes first. Throws the CommandError of `call` where the scenario is invalid.
std::vector<RegionSet> region_sets(const planning::v1::PlanMotionRequest& scenario, int resolution,
                                   const RegionCall& call);

/// What of the scene is no part of any set, a sentence for people each: moving and fixed objects.
std::vector<std::string> left_out(const planning::v1::PlanMotionRequest& scenario);

}  // namespace dualarm
