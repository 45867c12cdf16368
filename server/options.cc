#include "server/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

#include "server/listen_address.h"

namespace dualarm {
namespace {

constexpr int kUsageError = 2;

void add_request_limits(CLI::App& app, RequestLimits& limits) {
  const auto add = [&app](const char* flag, int& limit, const char* environment, const char* what) {
    app.add_option(flag, limit, what)->envname(environment)->check(CLI::Range(1, 10'000'000));
  };
  add("--max-objects", limits.objects, "DUALARM_MAX_OBJECTS", "Objects of a scene");
  add("--max-poses", limits.poses, "DUALARM_MAX_POSES", "Poses of an object's track");
  add("--max-knots", limits.knots, "DUALARM_MAX_KNOTS", "Knots, and arcs, of a trajectory that is to be verified");
  add("--max-table-lines", limits.table_lines, "DUALARM_MAX_TABLE_LINES", "Positions or velocities of a torque table");
  add("--max-table-entries", limits.table_entries, "DUALARM_MAX_TABLE_ENTRIES", "Entries of a torque table");
}

void add_options(CLI::App& app, ServerOptions& options) {
  app.set_version_flag("--version", "dualarm-server " DUALARM_VERSION);
  app.option_defaults()->always_capture_default();
  app.add_option("--listen", options.listen, "HOST:PORT (port 0: any free one) or unix:PATH")
      ->envname("DUALARM_LISTEN")
      ->check(CLI::Validator(complaint_about_address, ""));
  app.add_option("--port-file", options.port_file, "Write the bound port to this file")->envname("DUALARM_PORT_FILE");
  app.add_flag("--allow-insecure-remote", options.allow_insecure_remote,
               "Serve plaintext on addresses other than loopback and unix sockets")
      ->envname("DUALARM_ALLOW_INSECURE_REMOTE");
  app.add_option("--max-message-mib", options.max_message_mib, "Largest request in MiB")
      ->envname("DUALARM_MAX_MESSAGE_MIB")
      ->check(CLI::Range(1, 1024));
  app.add_option("--worker-threads", options.worker_threads, "Quick computations at once")
      ->envname("DUALARM_WORKER_THREADS")
      ->check(CLI::Range(1, 1024));
  app.add_option("--queue-capacity", options.queue_capacity, "Requests that may wait for a worker")
      ->envname("DUALARM_QUEUE_CAPACITY")
      ->check(CLI::Range(0, 1'000'000));
  app.add_option("--search-threads", options.search_threads, "Searches at once")
      ->envname("DUALARM_SEARCH_THREADS")
      ->check(CLI::Range(1, 1024));
  app.add_option("--search-queue", options.search_queue, "Requests that may wait for a search")
      ->envname("DUALARM_SEARCH_QUEUE")
      ->check(CLI::Range(0, 1'000'000));
  app.add_option("--niceness", options.niceness,
                 "How far threads that search or draw stand back behind quick ones: 0 not at all")
      ->envname("DUALARM_NICENESS")
      ->check(CLI::Range(0, 19));
  app.add_option("--max-streams", options.max_streams, "Calls of PlanMotionStream and PlanMotionBatch at once")
      ->envname("DUALARM_MAX_STREAMS")
      ->check(CLI::Range(1, 1'000'000));
  app.add_option("--batch-in-flight", options.batch_in_flight, "Requests of one batch that are read and not answered")
      ->envname("DUALARM_BATCH_IN_FLIGHT")
      ->check(CLI::Range(1, 10'000));
  app.add_option("--search-memory-mib", options.search_memory_mib, "What one search may take in MiB")
      ->envname("DUALARM_SEARCH_MEMORY_MIB")
      ->check(CLI::Range(1, 65536));
  add_request_limits(app, options.request);
  app.add_option("--planning-budget", options.planning_budget, "Longest computation of one request in seconds")
      ->envname("DUALARM_PLANNING_BUDGET")
      ->check(CLI::Range(1e-3, 1e6));
  app.add_option("--drain-seconds", options.drain_seconds,
                 "What running calls get to finish after SIGTERM or SIGINT, in seconds")
      ->envname("DUALARM_DRAIN_SECONDS")
      ->check(CLI::Range(0.0, 3600.0));
  app.add_option("--log-level", options.log_level, "How much is logged to stderr")
      ->envname("DUALARM_LOG_LEVEL")
      ->check(CLI::IsMember({"trace", "debug", "info", "warning", "error", "critical", "off"}));
}

}  // namespace

std::variant<ServerOptions, ExitStatus> read_options(int argc, const char* const* argv) {
  ServerOptions options;
  options.worker_threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  options.search_threads = options.worker_threads;
  CLI::App app("Plans time-optimal, verified motions of two arms over gRPC", "dualarm-server");
  add_options(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return ExitStatus{app.exit(error) == 0 ? 0 : kUsageError};
  }
  return options;
}

}  // namespace dualarm
