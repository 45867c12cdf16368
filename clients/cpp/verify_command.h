// dualarm verify: is a motion safe and within its limits at every instant?
#pragma once

#include <string>

#include "clients/cpp/command_error.h"
#include "clients/cpp/connection_options.h"

namespace CLI {
class App;
}

namespace dualarm {

class Interruption;

struct VerifyCommand {
  ConnectionOptions connection;
  std::string file;  ///< "-" is stdin
  std::string plan;  ///< empty: `file` is a VerifyMotionRequest
  bool json = false;

  void add_to(CLI::App& command);
  /// kDone where every demand is kept, kNegative where one is broken or unproven.
  ExitStatus run(const Interruption& interruption) const;
};

}  // namespace dualarm
