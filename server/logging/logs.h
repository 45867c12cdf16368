#pragma once

#include <google/protobuf/message.h>
#include <grpcpp/support/status_code_enum.h>

#include <string>
#include <string_view>

namespace dualarm {

/// Sends the log, gRPC's own included, to stderr. level: one of trace, debug, info, warning, error, critical, off.
/// json: one JSON object a line instead of text.
void start_logs(const std::string& level, bool json = false);

/// What the code that answers knows of a call or of one request of a batch.
struct CallRecord {
  std::string_view rpc;
  grpc::StatusCode code;
  std::string_view note;
  double queued_milliseconds;
  double total_milliseconds;
};

/// Whether log_call() writes anything: notes for nobody cost time.
bool logs_details();

/// A line at level debug. The one line at level info that every call has is call_observer's.
void log_call(const CallRecord& record);

/// From now on log_bug() also keeps requests as files in this folder (replay_folder.h). Call it before serving; like
/// the log, it is one for the process. Throws std::runtime_error where the folder is no good.
void keep_bugs_in(const std::string& folder, int limit);

/// Logs a bug with the request that met it, as JSON (cut to 64 KiB); the id is in the log and for the caller.
std::string log_bug(std::string_view rpc, std::string_view what, const google::protobuf::Message& request);

}  // namespace dualarm
