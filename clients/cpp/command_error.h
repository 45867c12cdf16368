// How a command ends: its exit status, and the error that carries one.
#pragma once

#include <grpcpp/support/status.h>

#include <stdexcept>
#include <string>

#include "dualarm/planning/v1/planning_service.pb.h"

namespace dualarm {

enum class ExitStatus : int {
  kDone = 0,          ///< a plan, a motion, a verified motion, a healthy server
  kFailure = 1,       ///< anything without a number of its own, such as a file that cannot be written
  kInvalid = 2,       ///< usage, a file that is not a request, a request or a token that the server refuses
  kNegative = 3,      ///< plan, portrait: infeasible; verify: a demand is broken
  kUndecided = 4,     ///< neither was reached in time
  kUnreachable = 5,   ///< no server answers, or it cannot take the work now
  kInterrupted = 130  ///< by SIGINT or SIGTERM
};

/// Ends the command with `status`; what() is printed to stderr.
class CommandError : public std::runtime_error {
 public:
  CommandError(ExitStatus status, const std::string& message) : std::runtime_error(message), status_(status) {}
  ExitStatus status() const { return status_; }

 private:
  ExitStatus status_;
};

/// The error that a failed call ends in: the server's message, then every field violation on a line of its own,
/// "  robot.arms[0].link.length_m: must be above 0". `server` is named where the call did not get through.
CommandError error_of_call(const grpc::Status& status, const std::string& server);

/// The end that an answer of the planner is.
ExitStatus exit_status_of(const planning::v1::PlanMotionResponse& response);

}  // namespace dualarm
