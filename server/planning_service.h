#pragma once

#include <atomic>
#include <chrono>

#include "server/calls/places.h"
#include "server/calls/planning_task.h"
#include "server/calls/ticker.h"
#include "server/planning_functions.h"
#include "server/planning_methods.h"
#include "server/pools/worker_pools.h"
#include "server/wire.h"

namespace dualarm {

/// What one server allows its callers.
struct ServiceLimits {
  std::chrono::nanoseconds longest_planning;  ///< of one request
  std::size_t search_memory = 0;              ///< bytes of one search
  int streams = 0;                            ///< open at once, batches included
  int batch_in_flight = 0;                    ///< requests of one batch that are read and not answered
  RequestLimits request;
  std::chrono::nanoseconds trial{};  ///< processor time for which gRPC's thread may try a plan
};

/// The RPCs of proto/dualarm/planning/v1/planning_service.proto. Each parses, has a worker compute, and renders; no
/// state is kept between calls.
class PlanningService final : public PlanningMethods {
 public:
  /// `pools` must outlive the service and every call, the service every call.
  PlanningService(PlanningFunctions functions, WorkerPools& pools, const ServiceLimits& limits);

  /// From now on no batch reads another request: it answers what it has read and ends.
  void drain() { drains_ = true; }

  grpc::ServerUnaryReactor* PlanMotion(grpc::CallbackServerContext* context, const wire::PlanMotionRequest* request,
                                       wire::PlanMotionResponse* response) override;
  grpc::ServerWriteReactor<wire::PlanMotionStreamResponse>* PlanMotionStream(
      grpc::CallbackServerContext* context, const wire::PlanMotionStreamRequest* request) override;
  BatchReactor* PlanMotionBatch(grpc::CallbackServerContext* context) override;
  grpc::ServerUnaryReactor* VerifyMotion(grpc::CallbackServerContext* context, const wire::VerifyMotionRequest* request,
                                         wire::VerifyMotionResponse* response) override;
  grpc::ServerUnaryReactor* GetForbiddenRegion(grpc::CallbackServerContext* context,
                                               const wire::GetForbiddenRegionRequest* request,
                                               wire::GetForbiddenRegionResponse* response) override;
  grpc::ServerUnaryReactor* GetPhasePortrait(grpc::CallbackServerContext* context,
                                             const wire::GetPhasePortraitRequest* request,
                                             wire::GetPhasePortraitResponse* response) override;

 private:
  Places trials_{1};  // gRPC has two threads or more: one stays free for whoever only asks for health
  Planner planner_;
  Places streams_;
  int batch_in_flight_;
  std::atomic<bool> drains_ = false;
  Ticker ticker_;
};

}  // namespace dualarm
