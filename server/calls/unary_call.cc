#include "server/calls/unary_call.h"

#include <utility>

#include "server/errors.h"

namespace dualarm {

grpc::ServerUnaryReactor* UnaryCall::start(WorkerPool& pool, std::string_view rpc,
                                           const grpc::CallbackServerContext& context,
                                           const google::protobuf::Message& request, Work work) {
  auto* call = new UnaryCall(rpc, context, request, std::move(work));  // deleted by OnDone
  if (!pool.try_submit([call] { call->run(); })) call->finish({overloaded(), "queue full"});
  return call;
}

UnaryCall::UnaryCall(std::string_view rpc, const grpc::CallbackServerContext& context,
                     const google::protobuf::Message& request, Work work)
    : caller_(rpc, context), request_(request), work_(std::move(work)) {}

void UnaryCall::run() {
  const auto waited = Caller::Clock::now() - caller_.since();
  Answer answered = answer_of(caller_.rpc(), request_, [this] { return answer(); });
  answered.waited = waited;
  finish(answered);
}

Answer UnaryCall::answer() const {
  if (caller_.has_left()) return gone("before it began");
  Answer answered = work_(caller_);
  return caller_.has_left() ? gone("while it ran") : answered;
}

void UnaryCall::finish(const Answer& answer) {
  caller_.log(answer);
  Finish(answer.status);  // the call may be gone from here on
}

grpc::ServerUnaryReactor* PlanCall::start(const Planner& planner, const grpc::CallbackServerContext& context,
                                          const wire::PlanMotionRequest& request, wire::PlanMotionResponse& response) {
  auto* call = new PlanCall(planner, context, request, response);  // deleted by OnDone
  call->task_.start_here();
  return call;
}

PlanCall::PlanCall(const Planner& planner, const grpc::CallbackServerContext& context,
                   const wire::PlanMotionRequest& request, wire::PlanMotionResponse& response)
    : caller_("PlanMotion", context),
      task_(planner, caller_, request, response, WhenFull::kRefuse, [this](const Answer& answer) {
        caller_.log(answer);
        Finish(answer.status);  // the call may be gone from here on
      }) {}

}  // namespace dualarm
