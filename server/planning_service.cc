#include "server/planning_service.h"

#include <fmt/format.h>

#include <utility>

#include "server/calls/batch_call.h"
#include "server/calls/stream_call.h"
#include "server/calls/unary_call.h"
#include "server/errors.h"
#include "server/request/requests.h"
#include "server/response/responses.h"

namespace dualarm {
namespace {

// Half of the shortest time between two progress messages, so that none comes much later than it may.
constexpr std::chrono::milliseconds kTick = ProgressPace::kShortest / 2;

std::string note_on(const wire::GetPhasePortraitResponse& response) {
  if (response.has_infeasible()) return fmt::format("infeasible {}", wire::Reason_Name(response.infeasible().reason()));
  if (response.has_undecided()) return "undecided";
  return fmt::format("motion duration_s={:.6f} {}", response.duration_s(), wire::Claim_Name(response.claim()));
}

}  // namespace

PlanningService::PlanningService(PlanningFunctions functions, WorkerPools& pools, const ServiceLimits& limits)
    : planner_{std::move(functions),
               pools,
               limits.longest_planning,
               limits.search_memory,
               limits.request,
               limits.trial,
               trials_,
               ticker_},
      streams_(limits.streams),
      batch_in_flight_(limits.batch_in_flight),
      ticker_(kTick) {}

grpc::ServerUnaryReactor* PlanningService::PlanMotion(grpc::CallbackServerContext* context,
                                                      const wire::PlanMotionRequest* request,
                                                      wire::PlanMotionResponse* response) {
  return PlanCall::start(planner_, *context, *request, *response);
}

grpc::ServerWriteReactor<wire::PlanMotionStreamResponse>* PlanningService::PlanMotionStream(
    grpc::CallbackServerContext* context, const wire::PlanMotionStreamRequest* request) {
  return StreamCall::start(planner_, ticker_, streams_, *context, *request);
}

BatchReactor* PlanningService::PlanMotionBatch(grpc::CallbackServerContext* context) {
  return BatchCall::start({planner_, ticker_, streams_, batch_in_flight_, drains_}, *context);
}

grpc::ServerUnaryReactor* PlanningService::VerifyMotion(grpc::CallbackServerContext* context,
                                                        const wire::VerifyMotionRequest* request,
                                                        wire::VerifyMotionResponse* response) {
  return UnaryCall::start(planner_.pools.quick, "VerifyMotion", *context, *request,
                          [this, request, response](const Caller& caller) {
                            const Parsed<VerifyWish> parsed = parse(*request, planner_.limits);
                            if (const auto* violations = std::get_if<Violations>(&parsed)) return refusal(*violations);
                            const auto& wish = std::get<VerifyWish>(parsed);
                            const Verification verification = planner_.functions.verify(
                                wish.problem, wish.trajectory, caller.budget(planner_.longest), wish.check_end_states);
                            *response = response_message(verification);
                            return Answer{grpc::Status::OK, verification.holds() ? "holds" : "does not hold"};
                          });
}

grpc::ServerUnaryReactor* PlanningService::GetForbiddenRegion(grpc::CallbackServerContext* context,
                                                              const wire::GetForbiddenRegionRequest* request,
                                                              wire::GetForbiddenRegionResponse* response) {
  return UnaryCall::start(
      planner_.pools.drawings, "GetForbiddenRegion", *context, *request,
      [this, request, response](const Caller& caller) {
        const Parsed<RegionWish> parsed = parse(*request, planner_.limits);
        if (const auto* violations = std::get_if<Violations>(&parsed)) return refusal(*violations);
        const auto& wish = std::get<RegionWish>(parsed);
        const auto contours =
            planner_.functions.forbidden_region(wish.problem, wish.resolution, caller.budget(planner_.longest));
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
      planner_.pools.drawings, "GetPhasePortrait", *context, *request, [this, request, response](const Caller& caller) {
        const Parsed<PortraitWish> parsed = parse(*request, planner_.limits);
        if (const auto* violations = std::get_if<Violations>(&parsed)) return refusal(*violations);
        const auto& wish = std::get<PortraitWish>(parsed);
        const auto portrait =
            planner_.functions.arm_portrait(wish.problem, wish.arm, wish.resolution, caller.budget(planner_.longest));
        if (!portrait) return Answer{out_of_time("the phase portrait", "a lower resolution"), "out of time"};
        *response = response_message(*portrait);
        return Answer{grpc::Status::OK, note_on(*response)};
      });
}

}  // namespace dualarm
