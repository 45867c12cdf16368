#pragma once

#include <filesystem>
#include <string>

#include "clients/cpp/json_file.h"
#include "dualarm/planning/v1/planning_service.pb.h"

namespace dualarm {

/// Path of one of the project's scenarios.
inline std::string scenario(const std::string& name) {
  return (std::filesystem::path(DUALARM_SOURCE_DIR) / "scenarios" / (name + ".json")).string();
}

/// What that scenario asks for.
inline planning::v1::PlanMotionRequest request_of(const std::string& name) {
  planning::v1::PlanMotionRequest request;
  read_json(scenario(name), request);
  return request;
}

}  // namespace dualarm
