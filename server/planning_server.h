#pragma once

#include <grpcpp/server.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "server/calls/open_calls.h"
#include "server/heap_trimmer.h"
#include "server/logging/call_log.h"
#include "server/metrics/metrics.h"
#include "server/metrics/metrics_endpoint.h"
#include "server/options.h"
#include "server/planning_service.h"
#include "server/pools/worker_pools.h"
#include "server/security/guarded_service.h"
#include "server/security/security.h"

namespace dualarm {

/// A running server: planning service, health (for the whole server and per service), reflection. Serves from the end
/// of the constructor until drain().
class PlanningServer {
 public:
  /// Throws std::runtime_error, with a message for the operator, if the options are no good (complaints_about) or the
  /// address cannot be listened on.
  PlanningServer(const ServerOptions& options, PlanningFunctions functions);

  /// Drains without patience if drain() was not called.
  ~PlanningServer();

  PlanningServer(const PlanningServer&) = delete;
  PlanningServer& operator=(const PlanningServer&) = delete;

  /// Bound TCP port; gRPC's 1 for unix sockets.
  int port() const { return port_; }

  /// Where clients reach it, with the port that was bound.
  const std::string& address() const { return address_; }

  /// Where Prometheus finds /metrics; "" for nowhere.
  std::string metrics_address() const { return endpoint_ ? endpoint_->address() : ""; }

  const Metrics& metrics() const { return metrics_; }

  /// "plaintext", "TLS with <certificate>; 3 tokens", ...
  const std::string& protection() const { return security_.summary(); }

  /// Reads certificates and tokens anew and logs what came of it; what is no good stays as it was.
  void reload();

  /// Health says NOT_SERVING from now on, and everything is served as before.
  void announce_end();

  /// Health says NOT_SERVING, new calls are refused with UNAVAILABLE, running ones get this long to finish; then the
  /// connections are closed, which callers who still wait hear as UNAVAILABLE, too.
  void drain(std::chrono::nanoseconds patience);

 private:
  CallLog log_;  // this and the metrics: calls report to them until the server has shut down
  Metrics metrics_;
  Security security_;
  PlanningService service_;
  WorkerPools pools_;  // before the server: calls run on them until it has shut down; after the service, whose
                       // functions their threads use to the last
  OpenCalls open_calls_;
  GuardedService guarded_;
  int port_ = 0;
  std::string listen_;
  std::string address_;
  std::unique_ptr<grpc::Server> server_;
  std::optional<MetricsEndpoint> endpoint_;
  HeapTrimmer heap_trimmer_;
};

}  // namespace dualarm
