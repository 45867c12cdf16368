#pragma once

#include <grpcpp/server.h>

#include <chrono>
#include <memory>
#include <string>

#include "server/options.h"
#include "server/planning_service.h"
#include "server/worker_pools.h"

namespace dualarm {

/// A running server: planning service, health (for the whole server and per service), reflection. Serves from the end
/// of the constructor until drain().
class PlanningServer {
 public:
  /// Throws std::runtime_error, with a message for the operator, if the address cannot be listened on.
  PlanningServer(const ServerOptions& options, PlanningFunctions functions);

  /// Drains without patience if drain() was not called.
  ~PlanningServer();

  PlanningServer(const PlanningServer&) = delete;
  PlanningServer& operator=(const PlanningServer&) = delete;

  /// Bound TCP port; gRPC's 1 for unix sockets.
  int port() const { return port_; }

  /// Where clients reach it, with the port that was bound.
  const std::string& address() const { return address_; }

  /// Health says NOT_SERVING, new calls are refused, running ones get this long to finish and are then cancelled.
  void drain(std::chrono::nanoseconds patience);

 private:
  PlanningService service_;
  WorkerPools pools_;  // before the server: calls run on them until it has shut down; after the service, whose
                       // functions their threads use to the last
  int port_ = 0;
  std::string address_;
  std::unique_ptr<grpc::Server> server_;
};

}  // namespace dualarm
