#pragma once

#include "server/calls/open_calls.h"
#include "server/planning_methods.h"
#include "server/security/admission.h"
#include "server/wire.h"

namespace dualarm {

/// The planning service behind its door: every RPC is refused with UNAVAILABLE once no calls are taken any more; else
/// it asks the admission, and goes on only where it said OK to the call.
class GuardedService final : public PlanningMethods {
 public:
  /// All must outlive this.
  GuardedService(PlanningMethods& behind, const Admission& admission, const OpenCalls& open)
      : behind_(behind), admission_(admission), open_(open) {}

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
  grpc::ServerWriteReactor<wire::PlanMotionStreamResponse>* PlanMotionStream(
      grpc::CallbackServerContext* context, const wire::PlanMotionStreamRequest* request) override;
  BatchReactor* PlanMotionBatch(grpc::CallbackServerContext* context) override;

 private:
  PlanningMethods& behind_;
  const Admission& admission_;
  const OpenCalls& open_;
};

}  // namespace dualarm
