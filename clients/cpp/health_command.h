// dualarm health: is the server serving?
#pragma once

#include "clients/cpp/command_error.h"
#include "clients/cpp/connection_options.h"

namespace CLI {
class App;
}

namespace dualarm {

class Interruption;

struct HealthCommand {
  ConnectionOptions connection;
  std::string service = "dualarm.planning.v1.PlanningService";

  void add_to(CLI::App& command);
  /// kDone where it serves, kUnreachable where it does not.
  ExitStatus run(const Interruption& interruption) const;
};

}  // namespace dualarm
