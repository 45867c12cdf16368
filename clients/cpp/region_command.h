// dualarm region: the joint positions at which two arms collide, the paper's figure 2.
#pragma once

#include <string>

#include "clients/cpp/command_error.h"
#include "clients/cpp/connection_options.h"

namespace CLI {
class App;
}

namespace dualarm {

class Interruption;

struct RegionCommand {
  ConnectionOptions connection;
  std::string file;  ///< "-" is stdin
  bool json = false;
  std::string svg;     ///< file for the drawing; empty: none
  int resolution = 0;  ///< points a side; 0: the command's choice

  void add_to(CLI::App& command);
  ExitStatus run(const Interruption& interruption) const;
};

}  // namespace dualarm
