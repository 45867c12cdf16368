#include "server/security/guarded_service.h"

#include "server/errors.h"

namespace dualarm {
namespace {

template <typename Reactor>
class RefusedCall final : public Reactor {
 public:
  explicit RefusedCall(const grpc::Status& status) { this->Finish(status); }
  void OnDone() override { delete this; }
};

template <typename Reactor, typename Serve>
Reactor* guard(const Admission& admission, const OpenCalls& open, const grpc::CallbackServerContext* context,
               const Serve& serve) {
  if (open.closed()) return new RefusedCall<Reactor>(draining());
  // The address under which call_observer lets the call enter.
  const grpc::Status status = admission.status_of(static_cast<const grpc::ServerContextBase*>(context));
  return status.ok() ? serve() : new RefusedCall<Reactor>(status);
}

}  // namespace

grpc::ServerUnaryReactor* GuardedService::PlanMotion(grpc::CallbackServerContext* context,
                                                     const wire::PlanMotionRequest* request,
                                                     wire::PlanMotionResponse* response) {
  return guard<grpc::ServerUnaryReactor>(admission_, open_, context,
                                         [&] { return behind_.PlanMotion(context, request, response); });
}

grpc::ServerUnaryReactor* GuardedService::VerifyMotion(grpc::CallbackServerContext* context,
                                                       const wire::VerifyMotionRequest* request,
                                                       wire::VerifyMotionResponse* response) {
  return guard<grpc::ServerUnaryReactor>(admission_, open_, context,
                                         [&] { return behind_.VerifyMotion(context, request, response); });
}

grpc::ServerUnaryReactor* GuardedService::GetForbiddenRegion(grpc::CallbackServerContext* context,
                                                             const wire::GetForbiddenRegionRequest* request,
                                                             wire::GetForbiddenRegionResponse* response) {
  return guard<grpc::ServerUnaryReactor>(admission_, open_, context,
                                         [&] { return behind_.GetForbiddenRegion(context, request, response); });
}

grpc::ServerUnaryReactor* GuardedService::GetPhasePortrait(grpc::CallbackServerContext* context,
                                                           const wire::GetPhasePortraitRequest* request,
                                                           wire::GetPhasePortraitResponse* response) {
  return guard<grpc::ServerUnaryReactor>(admission_, open_, context,
                                         [&] { return behind_.GetPhasePortrait(context, request, response); });
}

grpc::ServerWriteReactor<wire::PlanMotionStreamResponse>* GuardedService::PlanMotionStream(
    grpc::CallbackServerContext* context, const wire::PlanMotionStreamRequest* request) {
  return guard<grpc::ServerWriteReactor<wire::PlanMotionStreamResponse>>(
      admission_, open_, context, [&] { return behind_.PlanMotionStream(context, request); });
}

BatchReactor* GuardedService::PlanMotionBatch(grpc::CallbackServerContext* context) {
  return guard<BatchReactor>(admission_, open_, context, [&] { return behind_.PlanMotionBatch(context); });
}

}  // namespace dualarm
