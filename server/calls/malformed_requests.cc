#include "server/calls/malformed_requests.h"

#include <string_view>

#include "server/errors.h"
#include "server/wire.h"

namespace dualarm {
namespace {

using grpc::experimental::InterceptionHookPoints;
using grpc::experimental::InterceptorBatchMethods;
using grpc::experimental::ServerRpcInfo;

// The method of PlanningService called "/dualarm.planning.v1.PlanningService/PlanMotion"; null for any other.
const google::protobuf::MethodDescriptor* method_called(std::string_view path) {
  static const auto* const kService =
      wire::PlanMotionRequest::descriptor()->file()->FindServiceByName("PlanningService");
  static const std::string kPrefix = "/" + kService->full_name() + "/";
  return path.starts_with(kPrefix) ? kService->FindMethodByName(std::string(path.substr(kPrefix.size()))) : nullptr;
}

class Explainer final : public grpc::experimental::Interceptor {
 public:
  explicit Explainer(const google::protobuf::MethodDescriptor& method) : method_(method) {}

  void Intercept(InterceptorBatchMethods* batch) override {
    if (batch->QueryInterceptionHookPoint(InterceptionHookPoints::PRE_SEND_STATUS)) {
      const grpc::Status status = batch->GetSendStatus();
      if (status.error_code() == grpc::StatusCode::UNIMPLEMENTED && status.error_message().empty()) {
        batch->ModifySendStatus(malformed_request(method_.input_type()->full_name()));
      }
    }
    batch->Proceed();
  }

 private:
  const google::protobuf::MethodDescriptor& method_;
};

class ExplainerFactory final : public grpc::experimental::ServerInterceptorFactoryInterface {
 public:
  grpc::experimental::Interceptor* CreateServerInterceptor(ServerRpcInfo* call) override {
    const auto* method = method_called(call->method());
    return method == nullptr ? nullptr : new Explainer(*method);  // gRPC deletes it
  }
};

}  // namespace

std::unique_ptr<grpc::experimental::ServerInterceptorFactoryInterface> explain_malformed_requests() {
  return std::make_unique<ExplainerFactory>();
}

}  // namespace dualarm
