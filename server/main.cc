#include <signal.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <stdexcept>

#include "server/logs.h"
#include "server/options.h"
#include "server/planning_functions.h"
#include "server/planning_server.h"

namespace {

using dualarm::ServerOptions;

// Before any thread begins, so that all of them inherit it and only sigwait takes the signals.
sigset_t block_stop_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

void write_port(const std::string& path, int port) {
  if (path.empty()) return;
  std::ofstream file(path);
  file << port << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write the port to " + path);
}

void serve(const ServerOptions& options, const sigset_t& stop_signals) {
  dualarm::PlanningServer server(options, dualarm::core_functions());
  write_port(options.port_file, server.port());
  spdlog::info("dualarm-server " DUALARM_VERSION " listening on {}", server.address());
  int signal = 0;
  sigwait(&stop_signals, &signal);
  spdlog::info("{}: draining for at most {} s", signal == SIGTERM ? "SIGTERM" : "SIGINT", options.drain_seconds);
  server.drain(std::chrono::nanoseconds(static_cast<std::int64_t>(options.drain_seconds * 1e9)));
  spdlog::info("stopped");
}

}  // namespace

int main(int argc, char** argv) {
  const sigset_t stop_signals = block_stop_signals();
  const auto read = dualarm::read_options(argc, argv);
  if (const auto* exit_status = std::get_if<dualarm::ExitStatus>(&read)) return exit_status->value;
  const auto& options = std::get<ServerOptions>(read);
  dualarm::start_logs(options.log_level);
  try {
    serve(options, stop_signals);
  } catch (const std::exception& exception) {
    spdlog::critical("{}", exception.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
