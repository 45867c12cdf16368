// dualarm batch: plan many requests through one stream.
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

struct BatchCommand {
  ConnectionOptions connection;
  std::vector<std::string> sources;  ///< files, folders, "-" for stdin
  bool json = false;

  void add_to(CLI::App& command);
  /// The worst of the requests' ends.
  ExitStatus run(const Interruption& interruption) const;

 private:
  ExitStatus show(const planning::v1::PlanMotionBatchResponse& answer, const std::string& server) const;
};

}  // namespace dualarm
