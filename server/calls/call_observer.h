#pragma once

#include <grpcpp/support/server_interceptor.h>

#include <memory>

#include "server/calls/open_calls.h"
#include "server/logging/call_log.h"
#include "server/metrics/metrics.h"
#include "server/security/admission.h"

namespace dualarm {

/// What every call is held against and reported to. All must outlive the server.
struct CallObservers {
  const CallLog& log;
  Metrics& metrics;
  Admission& admission;
  OpenCalls& open;
  bool named_by_certificate = false;  ///< clients present certificates: the log has their names
};

/// Sees every call that reaches the server from outside of the code that answers it: names it (x-request-id), lets it
/// in or not (GuardedService holds it to that), reads what goes out, and when the status does, writes the call's line
/// and counts it.
std::unique_ptr<grpc::experimental::ServerInterceptorFactoryInterface> observe_calls(const CallObservers& observers);

}  // namespace dualarm
