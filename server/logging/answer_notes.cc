#include "server/logging/answer_notes.h"

#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"

namespace dualarm {
namespace {

constexpr std::size_t kMostMessageBytes = 200;  // of an error that carries no details

std::string outcome_of(const wire::PlanMotionResponse& response) {
  switch (response.outcome_case()) {
    case wire::PlanMotionResponse::kPlan:
      return "plan";
    case wire::PlanMotionResponse::kInfeasible:
      return "infeasible";
    case wire::PlanMotionResponse::kUndecided:
      return "undecided";
    case wire::PlanMotionResponse::OUTCOME_NOT_SET:
      break;
  }
  return "valid";
}

double milliseconds(double seconds) { return 1e3 * seconds; }

}  // namespace

PlanFigures figures_of(const wire::PlanMotionResponse& response) {
  PlanFigures figures;
  figures.outcome = outcome_of(response);
  if (response.has_plan()) {
    figures.method = response.plan().method();
    figures.gap = response.plan().certificate().gap();
  }
  const wire::Statistics& statistics = response.statistics();
  figures.searched = statistics.fallback_evaluation_count() > 0 || statistics.fallback_time_s() > 0.0;
  figures.planning_seconds = statistics.planning_time_s();
  figures.analytic_seconds = statistics.analytic_time_s();
  figures.verification_seconds = statistics.verification_time_s();
  figures.search_seconds = statistics.fallback_time_s();
  return figures;
}

std::vector<LogField> notes_on(const wire::PlanMotionResponse& response) {
  std::vector<LogField> notes = {{"outcome", outcome_of(response)}};
  if (response.has_plan()) {
    notes.push_back({"plan", wire::Method_Name(response.plan().method())});
    notes.push_back({"duration_s", response.plan().duration_s()});
    notes.push_back({"gap", response.plan().certificate().gap()});
  }
  if (response.has_infeasible()) notes.push_back({"reason", wire::Reason_Name(response.infeasible().reason())});
  const PlanFigures figures = figures_of(response);
  if (figures.planning_seconds > 0.0) notes.push_back({"planning_ms", milliseconds(figures.planning_seconds)});
  if (figures.verification_seconds > 0.0) notes.push_back({"verifying_ms", milliseconds(figures.verification_seconds)});
  if (figures.searched) notes.push_back({"searching_ms", milliseconds(figures.search_seconds)});
  return notes;
}

std::vector<LogField> notes_on(const wire::VerifyMotionResponse& response) {
  const wire::Verification& verification = response.verification();
  const bool holds = verification.collision_free() && verification.violations_size() == 0;
  return {{"outcome", holds ? "holds" : "does not hold"}};
}

std::vector<LogField> notes_on(const wire::GetForbiddenRegionResponse& response) {
  return {{"outcome", "region"}, {"contours", std::int64_t{response.contours_size()}}};
}

std::vector<LogField> notes_on(const wire::GetPhasePortraitResponse& response) {
  if (response.has_infeasible()) {
    return {{"outcome", "infeasible"}, {"reason", wire::Reason_Name(response.infeasible().reason())}};
  }
  if (response.has_undecided()) return {{"outcome", "undecided"}};
  return {{"outcome", "motion"}, {"duration_s", response.duration_s()}, {"claim", wire::Claim_Name(response.claim())}};
}

std::vector<LogField> notes_on(const grpc::Status& status) {
  if (status.ok()) return {};
  google::rpc::Status rich;
  google::rpc::ErrorInfo info;
  rich.ParseFromString(status.error_details());
  for (const auto& detail : rich.details()) {
    if (!detail.UnpackTo(&info)) continue;
    std::vector<LogField> notes = {{"reason", info.reason()}};
    for (const auto& [key, value] : info.metadata()) notes.push_back({key, value});
    return notes;
  }
  return {{"error", status.error_message().substr(0, kMostMessageBytes)}};
}

}  // namespace dualarm
