#pragma once

#include <grpcpp/support/status.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/logging/call_log.h"
#include "server/wire.h"

namespace dualarm {

/// What one plan's answer says to operators; of PlanMotion, of a stream's outcome, of one request of a batch.
struct PlanFigures {
  std::string outcome;                 ///< "plan", "infeasible", "undecided", "valid" (validate_only), "error"
  std::optional<wire::Method> method;  ///< of a plan
  std::optional<double> gap;           ///< of a plan: duration / lower bound - 1
  bool searched = false;               ///< the state-time search ran
  double planning_seconds = 0.0;       ///< all of planning
  double analytic_seconds = 0.0;       ///< fastest motions, delays, bounds
  double verification_seconds = 0.0;
  double search_seconds = 0.0;
};

PlanFigures figures_of(const wire::PlanMotionResponse& response);

/// Notes on messages that go out and on the error that ends a call, for its line in the log.
std::vector<LogField> notes_on(const wire::PlanMotionResponse& response);
std::vector<LogField> notes_on(const wire::VerifyMotionResponse& response);
std::vector<LogField> notes_on(const wire::GetForbiddenRegionResponse& response);
std::vector<LogField> notes_on(const wire::GetPhasePortraitResponse& response);

/// Reason and metadata of the ErrorInfo in an error's details, such as "reason" INVALID_REQUEST and "violation_count",
/// or the "id" of a bug; else the error's message, cut. Empty for OK.
std::vector<LogField> notes_on(const grpc::Status& status);

}  // namespace dualarm
