#pragma once

#include <grpcpp/support/server_interceptor.h>

#include <memory>

namespace dualarm {

/// gRPC's callback API answers bytes that are not the request's message by UNIMPLEMENTED without a word. This makes it
/// INVALID_ARGUMENT that says so, for the methods of PlanningService; whatever has a message passes as it is.
std::unique_ptr<grpc::experimental::ServerInterceptorFactoryInterface> explain_malformed_requests();

}  // namespace dualarm
