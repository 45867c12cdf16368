// dualarm portrait: one arm's phase plane, its fastest motion with nothing in its way.
#pragma once

#include <string>

#include "clients/cpp/command_error.h"
#include "clients/cpp/connection_options.h"

namespace CLI {
class App;
}

namespace dualarm {

class Interruption;

struct PortraitCommand {
  ConnectionOptions connection;
  std::string file;  ///< "-" is stdin
  std::string arm;   ///< whose task in `file` is drawn
  bool json = false;
  std::string svg;     ///< file for the drawing; empty: none
  int resolution = 0;  ///< points a curve; 0: the server's choice

  void add_to(CLI::App& command);
  /// kDone with a motion, kNegative where there is none, kUndecided where none was found.
  ExitStatus run(const Interruption& interruption) const;
};

}  // namespace dualarm
