#include "clients/cpp/command_error.h"

#include <google/rpc/error_details.pb.h>
#include <google/rpc/status.pb.h>
#include <grpcpp/support/error_details.h>

namespace dualarm {
namespace {

ExitStatus exit_status_of(grpc::StatusCode code) {
  switch (code) {
    case grpc::StatusCode::INVALID_ARGUMENT:
    case grpc::StatusCode::UNIMPLEMENTED:
    case grpc::StatusCode::UNAUTHENTICATED:
      return ExitStatus::kInvalid;
    case grpc::StatusCode::DEADLINE_EXCEEDED:
      return ExitStatus::kUndecided;
    case grpc::StatusCode::UNAVAILABLE:
    case grpc::StatusCode::RESOURCE_EXHAUSTED:
      return ExitStatus::kUnreachable;
    case grpc::StatusCode::CANCELLED:
      return ExitStatus::kInterrupted;
    default:
      return ExitStatus::kFailure;
  }
}

std::string headline(const grpc::Status& status, const std::string& server) {
  switch (status.error_code()) {
    case grpc::StatusCode::UNAVAILABLE:
      return "no answer from " + server + ": " + status.error_message();
    case grpc::StatusCode::DEADLINE_EXCEEDED:
      return "no answer in time: " + status.error_message();
    case grpc::StatusCode::RESOURCE_EXHAUSTED:
      return server + " cannot take the request: " + status.error_message();
    case grpc::StatusCode::CANCELLED:
      return "interrupted";
    default:
      return status.error_message();
  }
}

std::string violation_lines(const grpc::Status& status) {
  google::rpc::Status rich;
  if (status.error_details().empty() || !grpc::ExtractErrorDetails(status, &rich).ok()) return "";
  std::string lines;
  for (const auto& detail : rich.details()) {
    google::rpc::BadRequest bad_request;
    if (!detail.UnpackTo(&bad_request)) continue;
    for (const auto& violation : bad_request.field_violations()) {
      lines += "\n  " + violation.field() + ": " + violation.description();
    }
  }
  return lines;
}

}  // namespace

ExitStatus exit_status_of(const planning::v1::PlanMotionResponse& response) {
  if (response.has_infeasible()) return ExitStatus::kNegative;
  if (response.has_undecided()) return ExitStatus::kUndecided;
  return ExitStatus::kDone;
}

CommandError error_of_call(const grpc::Status& status, const std::string& server) {
  return {exit_status_of(status.error_code()), headline(status, server) + violation_lines(status)};
}

}  // namespace dualarm
