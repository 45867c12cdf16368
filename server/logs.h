#pragma once

#include <google/protobuf/message.h>
#include <grpcpp/support/status_code_enum.h>

#include <string>
#include <string_view>

namespace dualarm {

/// Sends the log, gRPC's own included, to stderr. level: one of trace, debug, info, warning, error, critical, off.
void start_logs(const std::string& level);

/// What one line about a finished call says.
struct CallRecord {
  std::string_view rpc;
  grpc::StatusCode code;
  std::string_view note;
  double queued_milliseconds;
  double total_milliseconds;
};

void log_call(const CallRecord& record);

/// Logs a bug with the request that met it, as JSON (cut to 64 KiB); the id is in the log and for the caller.
std::string log_bug(std::string_view rpc, std::string_view what, const google::protobuf::Message& request);

}  // namespace dualarm
