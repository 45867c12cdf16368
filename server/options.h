#pragma once

#include <string>
#include <variant>

#include "server/request/request_limits.h"

namespace dualarm {

/// How the server runs. Each can be given by flag or by environment variable (DUALARM_ and the flag's name in capitals
/// with underscores); the flag wins. `dualarm-server --help` prints the table.
struct ServerOptions {
  std::string listen = "127.0.0.1:50051";  ///< HOST:PORT (port 0: any free one) or unix:PATH
  std::string port_file;                   ///< where to write the bound port; empty: nowhere
  bool allow_insecure_remote = false;      ///< plaintext beyond loopback and unix sockets
  int max_message_mib = 4;                 ///< largest request, MiB
  int worker_threads = 1;                  ///< quick computations at once
  int queue_capacity = 1000;               ///< requests that may wait for a worker
  int search_threads = 1;                  ///< searches at once
  int search_queue = 64;                   ///< requests that may wait for a search
  int niceness = 19;                       ///< of threads that search or draw, 0 to 19
  int max_streams = 2000;                  ///< calls of PlanMotionStream and PlanMotionBatch at once
  int batch_in_flight = 64;                ///< requests of one batch that are read and not answered
  int search_memory_mib = 32;              ///< what one search may take, MiB
  RequestLimits request;                   ///< how much a request may hold
  double planning_budget = 10.0;           ///< s, longest computation of one request
  double drain_seconds = 10.0;             ///< s, that running calls get to finish after SIGTERM or SIGINT
  std::string log_level = "info";
};

/// The process ends at once with this status: help or version was asked for (0), or the options are wrong (2). What
/// there is to say has been printed.
struct ExitStatus {
  int value = 0;
};

std::variant<ServerOptions, ExitStatus> read_options(int argc, const char* const* argv);

}  // namespace dualarm
