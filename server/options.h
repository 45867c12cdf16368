#pragma once

#include <string>
#include <variant>

#include "server/request/request_limits.h"

namespace dualarm {

/// How the server runs. Each can be given by flag, by environment variable (DUALARM_ and the flag's name in capitals
/// with underscores) or in a TOML file (the flag's name without dashes in front), and wins in this order.
/// `dualarm-server --help` prints them all, docs/operations.md has them as a table.
struct ServerOptions {
  std::string listen = "127.0.0.1:50051";  ///< HOST:PORT (port 0: any free one) or unix:PATH
  std::string port_file;                   ///< where to write the bound port; empty: nowhere
  bool allow_insecure_remote = false;      ///< plaintext beyond loopback and unix sockets
  int max_message_mib = 4;                 ///< largest request, MiB
  int worker_threads = 1;                  ///< quick computations at once
  int queue_capacity = 1000;               ///< requests that may wait for a worker
  double inline_milliseconds = 5.0;        ///< that gRPC's own thread may work on a plan before a worker takes it over
  int search_threads = 1;                  ///< searches at once
  int search_queue = 64;                   ///< requests that may wait for a search
  int niceness = 19;                       ///< of threads that search or draw, 0 to 19
  int max_streams = 2000;                  ///< calls of PlanMotionStream and PlanMotionBatch at once
  int batch_in_flight = 64;                ///< requests of one batch that are read and not answered
  int search_memory_mib = 32;              ///< what one search may take, MiB
  RequestLimits request;                   ///< how much a request may hold
  double planning_budget = 10.0;           ///< s, longest computation of one request
  double drain_seconds = 10.0;             ///< s, that running calls get to finish after SIGTERM or SIGINT
  double drain_notice = 0.0;               ///< s, that it still serves while health says NOT_SERVING, before it drains
  std::string log_level = "info";
  std::string log_format = "text";  ///< or "json"
  std::string metrics_listen;       ///< HOST:PORT or PORT of /metrics; empty: nowhere
  std::string tls_cert;             ///< PEM file, the server's certificate chain; empty: plaintext
  std::string tls_key;              ///< PEM file, its private key
  std::string tls_client_ca;        ///< PEM file, who signs clients' certificates; empty: none are asked for
  std::string token_file;           ///< who may call, see server/token_table.h; empty: anybody
  int token_concurrency = 64;       ///< calls at once of one token
  std::string replay_dir;           ///< where requests that met a bug are kept; empty: only in the log
  int replay_limit = 100;           ///< files in there
  bool check_config = false;        ///< say what is wrong with all this and end
};

inline constexpr int kUsageError = 2;  ///< exit status for wrong options

/// The process ends at once with this status: help or version was asked for (0), or the options are wrong (2). What
/// there is to say has been printed.
struct ExitStatus {
  int value = 0;
};

std::variant<ServerOptions, ExitStatus> read_options(int argc, const char* const* argv);

/// All options as a table in Markdown: flag, environment variable, default, range, meaning.
std::string options_table();

}  // namespace dualarm
