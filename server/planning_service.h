#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include "core/arm_portrait.h"
#include "core/coordination/region.h"
#include "core/plan.h"
#include "dualarm/planning/v1/planning_service.grpc.pb.h"
#include "server/wire.h"
#include "server/worker_pool.h"

namespace dualarm {

/// What the service calls: plan, verify, forbidden_region and arm_portrait of core; tests put others in their place.
struct PlanningFunctions {
  std::function<Outcome(const Problem&, const Budget&)> plan;
  std::function<Verification(const Problem&, const Trajectory&, const Budget&, bool check_end_states)> verify;
  std::function<std::optional<std::vector<Contour>>(const Problem&, int resolution, const Budget&)> forbidden_region;
  std::function<std::optional<ArmPortrait>(const Problem&, int arm, int resolution, const Budget&)> arm_portrait;
};

/// The RPCs of proto/dualarm/planning/v1/planning_service.proto. Each parses, has a worker compute, and renders; no
/// state is kept between calls.
class PlanningService final : public wire::PlanningService::CallbackService {
 public:
  /// `pool` must outlive the service and every call. No call computes for longer than `longest_planning`.
  PlanningService(PlanningFunctions functions, WorkerPool& pool, std::chrono::nanoseconds longest_planning);

  grpc::ServerUnaryReactor* PlanMotion(grpc::CallbackServerContext* context, const wire::PlanMotionRequest* request,
                                       wire::PlanMotionResponse* response) override;
  grpc::ServerUnaryReactor* VerifyMotion(grpc::CallbackServerContext* context, const wire::VerifyMotionRequest* request,
                                         wire::VerifyMotionResponse* response) override;
  grpc::ServerUnaryReactor* GetForbiddenRegion(grpc::CallbackServerContext* context,
                                               const wire::GetForbiddenRegionRequest* request,
                                               wire::GetForbiddenRegionResponse* response) override;
  grpc::ServerUnaryReactor* GetPhasePortrait(grpc::CallbackServerContext* context,
                                             const wire::GetPhasePortraitRequest* request,
                                             wire::GetPhasePortraitResponse* response) override;

  /// Not served yet: UNIMPLEMENTED with what to use instead.
  grpc::ServerWriteReactor<wire::PlanMotionStreamResponse>* PlanMotionStream(
      grpc::CallbackServerContext* context, const wire::PlanMotionStreamRequest* request) override;
  grpc::ServerBidiReactor<wire::PlanMotionBatchRequest, wire::PlanMotionBatchResponse>* PlanMotionBatch(
      grpc::CallbackServerContext* context) override;

 private:
  PlanningFunctions functions_;
  WorkerPool& pool_;
  std::chrono::nanoseconds longest_planning_;
};

}  // namespace dualarm
