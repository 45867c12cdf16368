// Where the server is and how long to wait for it: the options that every command shares.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace dualarm {

struct ConnectionOptions {
  std::string server;       ///< HOST:PORT, or unix:PATH; empty: start the server beside this program
  double timeout_s = 60.0;  ///< for one call
};

/// `timeout`: what --timeout is said to mean.
void add_connection_options(CLI::App& command, ConnectionOptions& options,
                            const std::string& timeout = "seconds to wait for one answer");

}  // namespace dualarm
