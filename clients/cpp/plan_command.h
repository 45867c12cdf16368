// dualarm plan: plan one request or many.
#pragma once

#include <string>
#include <vector>

#include "clients/cpp/command_error.h"
#include "clients/cpp/connection_options.h"
#include "dualarm/planning/v1/planning_service.pb.h"

namespace CLI {
class App;
}

namespace dualarm {

class Interruption;
class PlanningClient;

struct PlanCommand {
  ConnectionOptions connection;
  std::vector<std::string> files;  ///< "-" is stdin
  bool json = false;
  bool table = false;
  bool progress = false;
  std::string output;      ///< file for the answer as JSON; empty: none
  std::string svg;         ///< file for the drawing; empty: none
  std::string svg_folder;  ///< folder for <file's stem>.svg of every request; empty: none

  void add_to(CLI::App& command);
  /// The worst of the requests' ends.
  ExitStatus run(const Interruption& interruption) const;

 private:
  ExitStatus plan_one(const PlanningClient& client, const std::string& file) const;
  void draw(const PlanningClient& client, const std::string& file, const planning::v1::PlanMotionRequest& request,
            const planning::v1::PlanMotionResponse& response) const;
};

}  // namespace dualarm
