#include "clients/cpp/connection_options.h"

#include <CLI/CLI.hpp>

namespace dualarm {

void add_connection_options(CLI::App& command, ConnectionOptions& options, const std::string& timeout) {
  command
      .add_option("--server", options.server,
                  "HOST:PORT of a dualarm-server; without it the server beside this program is started on a "
                  "private socket and stopped afterwards")
      ->check(CLI::Validator(
          [](const std::string& server) { return server.empty() ? "is empty: give HOST:PORT or unix:PATH" : ""; }, ""));
  command.add_option("--timeout", options.timeout_s, timeout)->check(CLI::Range(1e-3, 86400.0))->capture_default_str();
}

}  // namespace dualarm
