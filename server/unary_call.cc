#include "server/unary_call.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "server/errors.h"
#include "server/logs.h"

namespace dualarm {
namespace {

using Clock = std::chrono::steady_clock;

// What encoding the answer and sending it may take: a plan that is ready when the caller has gone is worth nothing.
constexpr std::chrono::milliseconds kAnswerMargin{20};

Clock::time_point on_steady_clock(std::chrono::system_clock::time_point time) {
  if (time == std::chrono::system_clock::time_point::max()) return Clock::time_point::max();
  const auto remaining = time - std::chrono::system_clock::now();
  constexpr std::chrono::hours kForever{24 * 365};  // gRPC's "no deadline" is far away, but not max() on every path
  return remaining > kForever ? Clock::time_point::max() : Clock::now() + remaining - kAnswerMargin;
}

double milliseconds(Clock::duration duration) { return std::chrono::duration<double, std::milli>(duration).count(); }

}  // namespace

grpc::ServerUnaryReactor* UnaryCall::start(WorkerPool& pool, std::string_view rpc,
                                           const grpc::CallbackServerContext& context,
                                           const google::protobuf::Message& request, Work work) {
  auto* call = new UnaryCall(rpc, context, request, std::move(work));  // deleted by OnDone
  if (!pool.try_submit([call] { call->run(); })) call->finish({overloaded(), "queue full"});
  return call;
}

UnaryCall::UnaryCall(std::string_view rpc, const grpc::CallbackServerContext& context,
                     const google::protobuf::Message& request, Work work)
    : rpc_(rpc), request_(request), work_(std::move(work)), caller_waits_until_(on_steady_clock(context.deadline())) {}

Budget UnaryCall::budget(std::chrono::nanoseconds at_most) const {
  return Budget(std::min(Clock::now() + at_most, caller_waits_until_), [this] { return cancelled(); });
}

void UnaryCall::run() {
  started_ = Clock::now();
  finish(answer());
}

Answer UnaryCall::answer() const {
  if (cancelled()) return {dualarm::cancelled(), "before it began"};
  try {
    Answer answer = work_(*this);
    return cancelled() ? Answer{dualarm::cancelled(), "while it ran"} : answer;
  } catch (const std::exception& exception) {
    return answer_to_exception(exception.what());
  } catch (...) {
    return answer_to_exception("an exception of unknown type");
  }
}

Answer UnaryCall::answer_to_exception(std::string_view what) const {
  const std::string id = log_bug(rpc_, what, request_);
  return {internal_error(id), "bug " + id};
}

void UnaryCall::finish(const Answer& answer) {
  log_call({rpc_, answer.status.error_code(), answer.note, milliseconds(started_ - received_),
            milliseconds(Clock::now() - received_)});
  Finish(answer.status);  // the call may be gone from here on
}

}  // namespace dualarm
