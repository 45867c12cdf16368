#pragma once

#include <grpcpp/support/byte_buffer.h>

#include <utility>

#include "dualarm/planning/v1/planning_service.grpc.pb.h"
#include "server/wire.h"

namespace dualarm {

/// What PlanMotionBatch reads and writes. Requests come as bytes: gRPC would end the stream at the first that is
/// malformed, and could not tell that from the end of the requests.
using BatchReactor = grpc::ServerBidiReactor<grpc::ByteBuffer, wire::PlanMotionBatchResponse>;

/// PlanMotionBatch in gRPC's callback API on top of the other methods: what its code generator would write for requests
/// that come as bytes.
template <typename OtherMethods>
class WithBatchMethod : public OtherMethods {
 public:
  WithBatchMethod() {
    constexpr int kIndex = 2;  // of the method in the proto file
    grpc::Service::MarkMethodRawCallback(
        kIndex, new grpc::internal::CallbackBidiHandler<grpc::ByteBuffer, wire::PlanMotionBatchResponse>(
                    [this](grpc::CallbackServerContext* context) { return PlanMotionBatch(context); }));
  }

  virtual BatchReactor* PlanMotionBatch(grpc::CallbackServerContext* context) = 0;

 private:
  using OtherMethods::PlanMotionBatch;  // of gRPC's synchronous API
};

/// The methods of the wire, all by gRPC's callback API.
using PlanningMethods = WithBatchMethod<wire::PlanningService::WithCallbackMethod_PlanMotion<
    wire::PlanningService::WithCallbackMethod_PlanMotionStream<wire::PlanningService::WithCallbackMethod_VerifyMotion<
        wire::PlanningService::WithCallbackMethod_GetForbiddenRegion<
            wire::PlanningService::WithCallbackMethod_GetPhasePortrait<wire::PlanningService::Service>>>>>>;

}  // namespace dualarm
