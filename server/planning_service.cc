#include "server/planning_service.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "server/errors.h"
#include "server/logs.h"
#include "server/request/requests.h"
#include "server/response/responses.h"
#include "server/unary_call.h"

namespace dualarm {
namespace {

// A call of an RPC that this version does not serve: it ends as soon as it begins.
template <typename Reactor>
class RefusedCall final : public Reactor {
 public:
  RefusedCall(std::string_view rpc, std::string_view instead) {
    log_call({rpc, grpc::StatusCode::UNIMPLEMENTED, "not served", 0.0, 0.0});
    this->Finish(not_served(rpc, instead));
  }
  void OnDone() override { delete this; }
};

Answer refusal(const Violations& violations) {
  return {invalid_argument(violations), fmt::format("{} violations", violations.count())};
}

std::string note_on(const wire::PlanMotionResponse& response) {
  switch (response.outcome_case()) {
    case wire::PlanMotionResponse::kPlan:
      return fmt::format("plan {} duration_s={:.6f} gap={:.2e}", wire::Method_Name(response.plan().method()),
                         response.plan().duration_s(), response.plan().certificate().gap());
    case wire::PlanMotionResponse::kInfeasible:
      return fmt::format("infeasible {}", wire::Reason_Name(response.infeasible().reason()));
    case wire::PlanMotionResponse::kUndecided:
      return "undecided";
    case wire::PlanMotionResponse::OUTCOME_NOT_SET:
      break;
  }
  return "valid";
}

std::string note_on(const wire::GetPhasePortraitResponse& response) {
  if (response.has_infeasible()) return fmt::format("infeasible {}", wire::Reason_Name(response.infeasible().reason()));
  if (response.has_undecided()) return "undecided";
  return fmt::format("motion duration_s={:.6f} {}", response.duration_s(), wire::Claim_Name(response.claim()));
}

}  // namespace

PlanningService::PlanningService(PlanningFunctions functions, WorkerPool& pool,
                                 std::chrono::nanoseconds longest_planning)
    : functions_(std::move(functions)), pool_(pool), longest_planning_(longest_planning) {}

grpc::ServerUnaryReactor* PlanningService::PlanMotion(grpc::CallbackServerContext* context,
                                                      const wire::PlanMotionRequest* request,
                                                      wire::PlanMotionResponse* response) {
  return UnaryCall::start(pool_, "PlanMotion", *context, *request, [this, request, response](const UnaryCall& call) {
    const Parsed<PlanWish> parsed = parse(*request);
    if (const auto* violations = std::get_if<Violations>(&parsed)) return refusal(*violations);
    const auto& wish = std::get<PlanWish>(parsed);
    if (!wish.validate_only) {
      const Budget budget = call.budget(std::min(wish.budget.value_or(longest_planning_), longest_planning_));
      *response = response_message(functions_.plan(wish.problem, budget));
    }
    return Answer{grpc::Status::OK, note_on(*response)};
  });
}

grpc::ServerUnaryReactor* PlanningService::VerifyMotion(grpc::CallbackServerContext* context,
                                                        const wire::VerifyMotionRequest* request,
                                                        wire::VerifyMotionResponse* response) {
  return UnaryCall::start(pool_, "VerifyMotion", *context, *request, [this, request, response](const UnaryCall& call) {
    const Parsed<VerifyWish> parsed = parse(*request);
    if (const auto* violations = std::get_if<Violations>(&parsed)) return refusal(*violations);
    const auto& wish = std::get<VerifyWish>(parsed);
    const Verification verification =
        functions_.verify(wish.problem, wish.trajectory, call.budget(longest_planning_), wish.check_end_states);
    *response = response_message(verification);
    return Answer{grpc::Status::OK, verification.holds() ? "holds" : "does not hold"};
  });
}

grpc::ServerUnaryReactor* PlanningService::GetForbiddenRegion(grpc::CallbackServerContext* context,
                                                              const wire::GetForbiddenRegionRequest* request,
                                                              wire::GetForbiddenRegionResponse* response) {
  return UnaryCall::start(
      pool_, "GetForbiddenRegion", *context, *request, [this, request, response](const UnaryCall& call) {
        const Parsed<RegionWish> parsed = parse(*request);
        if (const auto* violations = std::get_if<Violations>(&parsed)) return refusal(*violations);
        const auto& wish = std::get<RegionWish>(parsed);
        const auto contours =
            functions_.forbidden_region(wish.problem, wish.resolution, call.budget(longest_planning_));
        if (!contours)
          return Answer{out_of_time("the forbidden region", "a lower resolution or fewer objects"), "out of time"};
        *response = response_message(*contours, wish.problem);
        return Answer{grpc::Status::OK, fmt::format("{} contours", response->contours_size())};
      });
}

grpc::ServerUnaryReactor* PlanningService::GetPhasePortrait(grpc::CallbackServerContext* context,
                                                            const wire::GetPhasePortraitRequest* request,
                                                            wire::GetPhasePortraitResponse* response) {
  return UnaryCall::start(
      pool_, "GetPhasePortrait", *context, *request, [this, request, response](const UnaryCall& call) {
        const Parsed<PortraitWish> parsed = parse(*request);
        if (const auto* violations = std::get_if<Violations>(&parsed)) return refusal(*violations);
        const auto& wish = std::get<PortraitWish>(parsed);
        const auto portrait =
            functions_.arm_portrait(wish.problem, wish.arm, wish.resolution, call.budget(longest_planning_));
        if (!portrait) return Answer{out_of_time("the phase portrait", "a lower resolution"), "out of time"};
        *response = response_message(*portrait);
        return Answer{grpc::Status::OK, note_on(*response)};
      });
}

grpc::ServerWriteReactor<wire::PlanMotionStreamResponse>* PlanningService::PlanMotionStream(
    grpc::CallbackServerContext* /*context*/, const wire::PlanMotionStreamRequest* /*request*/) {
  return new RefusedCall<grpc::ServerWriteReactor<wire::PlanMotionStreamResponse>>(
      "PlanMotionStream", "call PlanMotion, which answers once with the same outcome");
}

grpc::ServerBidiReactor<wire::PlanMotionBatchRequest, wire::PlanMotionBatchResponse>* PlanningService::PlanMotionBatch(
    grpc::CallbackServerContext* /*context*/) {
  return new RefusedCall<grpc::ServerBidiReactor<wire::PlanMotionBatchRequest, wire::PlanMotionBatchResponse>>(
      "PlanMotionBatch", "call PlanMotion once for each request");
}

}  // namespace dualarm
