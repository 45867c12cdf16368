#include <signal.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <initializer_list>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "server/build_information.h"
#include "server/configuration_check.h"
#include "server/logging/logs.h"
#include "server/options.h"
#include "server/planning_functions.h"
#include "server/planning_server.h"

namespace {

using dualarm::ServerOptions;

sigset_t set_of(std::initializer_list<int> numbers) {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : numbers) sigaddset(&signals, number);
  return signals;
}

void write_port(const std::string& path, int port) {
  if (path.empty()) return;
  std::ofstream file(path);
  file << port << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write the port to " + path);
}

// Serves until SIGTERM or SIGINT comes, which it returns; SIGHUP reloads.
int wait_for_stop(dualarm::PlanningServer& server) {
  const sigset_t signals = set_of({SIGTERM, SIGINT, SIGHUP});
  for (int signal = 0;;) {
    sigwait(&signals, &signal);
    if (signal != SIGHUP) return signal;
    spdlog::info("SIGHUP: reading certificates and tokens anew");
    server.reload();
  }
}

std::chrono::nanoseconds nanoseconds(double seconds) {
  return std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9));
}

// For balancers to see that health says NOT_SERVING; a second signal ends it.
void give_notice(dualarm::PlanningServer& server, double seconds) {
  server.announce_end();
  if (seconds <= 0.0) return;
  spdlog::info("health says NOT_SERVING; still serving for {} s", seconds);
  const sigset_t signals = set_of({SIGTERM, SIGINT});
  const std::int64_t nanoseconds_of_notice = nanoseconds(seconds).count();
  const timespec notice = {nanoseconds_of_notice / 1'000'000'000, nanoseconds_of_notice % 1'000'000'000};
  sigtimedwait(&signals, nullptr, &notice);
}

void serve(const ServerOptions& options) {
  dualarm::PlanningServer server(options, dualarm::core_functions());
  write_port(options.port_file, server.port());
  spdlog::info("{}", dualarm::version_line());
  if (!server.metrics_address().empty()) spdlog::info("metrics on http://{}/metrics", server.metrics_address());
  spdlog::info("listening on {} ({})", server.address(), server.protection());
  const int signal = wait_for_stop(server);
  spdlog::info("{}: draining for at most {} s", signal == SIGTERM ? "SIGTERM" : "SIGINT", options.drain_seconds);
  give_notice(server, options.drain_notice);
  server.drain(nanoseconds(options.drain_seconds));
  spdlog::info("stopped");
}

int check_configuration(const ServerOptions& options) {
  const std::vector<std::string> complaints = dualarm::complaints_about(options);
  for (const std::string& complaint : complaints) std::cerr << "dualarm-server: " << complaint << '\n';
  if (complaints.empty()) std::cout << "the configuration is sound\n";
  return complaints.empty() ? EXIT_SUCCESS : dualarm::kUsageError;
}

}  // namespace

int main(int argc, char** argv) {
  // Before any thread begins, so that all of them inherit it and only sigwait takes the signals.
  const sigset_t taken = set_of({SIGTERM, SIGINT, SIGHUP});
  pthread_sigmask(SIG_BLOCK, &taken, nullptr);
  signal(SIGPIPE, SIG_IGN);  // a scraper of metrics that hangs up is no reason to end
  const auto read = dualarm::read_options(argc, argv);
  if (const auto* exit_status = std::get_if<dualarm::ExitStatus>(&read)) return exit_status->value;
  const auto& options = std::get<ServerOptions>(read);
  if (options.check_config) return check_configuration(options);
  dualarm::start_logs(options.log_level, options.log_format == "json");
  try {
    serve(options);
  } catch (const std::exception& exception) {
    spdlog::critical("{}", exception.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
