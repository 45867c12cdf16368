#include "server/calls/call_observer.h"

#include <chrono>
#include <string>
#include <string_view>
#include <utility>

#include "server/logging/answer_notes.h"
#include "server/logging/request_id.h"

namespace dualarm {
namespace {

using Clock = std::chrono::steady_clock;
using grpc::experimental::InterceptionHookPoints;
using grpc::experimental::InterceptorBatchMethods;
using grpc::experimental::ServerRpcInfo;

// "/dualarm.planning.v1.PlanningService/PlanMotion" is "PlanMotion"; other services keep their names.
std::string_view planning_method(std::string_view path) {
  static const std::string kPrefix =
      "/" + wire::PlanMotionRequest::descriptor()->file()->FindServiceByName("PlanningService")->full_name() + "/";
  return path.starts_with(kPrefix) ? path.substr(kPrefix.size()) : std::string_view();
}

using Metadata = std::multimap<grpc::string_ref, grpc::string_ref>;

constexpr char kAuthorizationKey[] = "authorization";

// Of two values the first; "" where there is none.
std::string_view value_of(const Metadata& metadata, const char* key) {
  const auto found = metadata.find(key);
  return found == metadata.end() ? std::string_view() : std::string_view(found->second.data(), found->second.size());
}

class ObservedCall final : public grpc::experimental::Interceptor {
 public:
  ObservedCall(ServerRpcInfo& call, const CallObservers& observers)
      : call_(call),
        observers_(observers),
        path_(call.method()),
        method_(planning_method(path_)),
        has_entered_(!method_.empty() && observers.open.enter()) {
    observers_.metrics.begin_call(path_);
  }

  // The line is written when the answer is on its way, so that nobody waits for it. A call whose status nobody sent:
  // its connection broke before.
  ~ObservedCall() override {
    if (!ended_) end({grpc::StatusCode::CANCELLED, "broken off"});
    observers_.log.write(report_, method_.empty());
    if (has_entered_) observers_.open.leave();
  }

  void Intercept(InterceptorBatchMethods* batch) override {
    if (batch->QueryInterceptionHookPoint(InterceptionHookPoints::POST_RECV_INITIAL_METADATA)) {
      begin(*batch->GetRecvInitialMetadata());
    }
    if (batch->QueryInterceptionHookPoint(InterceptionHookPoints::PRE_SEND_MESSAGE)) see(batch->GetSendMessage());
    if (batch->QueryInterceptionHookPoint(InterceptionHookPoints::PRE_SEND_STATUS)) end(batch->GetSendStatus());
    batch->Proceed();
  }

 private:
  void begin(const Metadata& metadata) {
    report_.request_id = request_id_or_new(value_of(metadata, kRequestIdKey));
    call_.server_context()->AddTrailingMetadata(kRequestIdKey, report_.request_id);
    if (method_.empty()) return;  // health and reflection are open to all (SECURITY.md)
    report_.caller = observers_.admission.enter(call_.server_context(), value_of(metadata, kAuthorizationKey)).caller;
    if (!report_.caller.empty() || !observers_.named_by_certificate) return;
    const auto names = call_.server_context()->auth_context()->GetPeerIdentity();
    if (!names.empty()) report_.caller.assign(names[0].data(), names[0].size());
  }

  // The method says of which type the message is.
  void see(const void* message) {
    if (message == nullptr || method_.empty()) return;
    if (method_ == "PlanMotion") {
      see_plan(*static_cast<const wire::PlanMotionResponse*>(message));
    } else if (method_ == "PlanMotionStream") {
      const auto& event = *static_cast<const wire::PlanMotionStreamResponse*>(message);
      if (event.has_outcome()) see_plan(event.outcome());
    } else if (method_ == "PlanMotionBatch") {
      see_answer(*static_cast<const wire::PlanMotionBatchResponse*>(message));
    } else if (method_ == "VerifyMotion") {
      report_.notes = notes_on(*static_cast<const wire::VerifyMotionResponse*>(message));
    } else if (method_ == "GetForbiddenRegion") {
      report_.notes = notes_on(*static_cast<const wire::GetForbiddenRegionResponse*>(message));
    } else if (method_ == "GetPhasePortrait") {
      report_.notes = notes_on(*static_cast<const wire::GetPhasePortraitResponse*>(message));
    }
  }

  void see_plan(const wire::PlanMotionResponse& response) {
    const PlanFigures figures = figures_of(response);
    observers_.metrics.count(figures);
    observers_.metrics.count_rest(Clock::now() - began_ - std::chrono::duration<double>(figures.planning_seconds));
    report_.notes = notes_on(response);
  }

  void see_answer(const wire::PlanMotionBatchResponse& answer) {
    PlanFigures figures;
    figures.outcome = "error";
    if (answer.has_response()) figures = figures_of(answer.response());
    observers_.metrics.count(figures);
    ++answers_;
    if (answer.has_error()) ++errors_;
  }

  // Before the status goes out, so that whoever has it and calls again finds the place free.
  void end(const grpc::Status& status) {
    ended_ = true;
    observers_.admission.leave(call_.server_context());
    const std::chrono::duration<double> duration = Clock::now() - began_;
    observers_.metrics.end_call(path_, status.error_code(), duration);
    report_.method = method_.empty() ? path_.substr(1) : method_;
    report_.code = status.error_code();
    report_.total_seconds = duration.count();
    if (!status.ok()) report_.notes = notes_on(status);
    if (method_ == "PlanMotionBatch") {
      report_.notes.push_back({"answers", answers_});
      report_.notes.push_back({"errors", errors_});
    }
  }

  ServerRpcInfo& call_;
  const CallObservers observers_;
  const std::string_view path_;    // gRPC's, as long as the call
  const std::string_view method_;  // of PlanningService, else empty
  const bool has_entered_;
  const Clock::time_point began_ = Clock::now();
  CallReport report_;
  std::int64_t answers_ = 0;
  std::int64_t errors_ = 0;
  bool ended_ = false;
};

class ObserverFactory final : public grpc::experimental::ServerInterceptorFactoryInterface {
 public:
  explicit ObserverFactory(const CallObservers& observers) : observers_(observers) {}

  grpc::experimental::Interceptor* CreateServerInterceptor(ServerRpcInfo* call) override {
    return new ObservedCall(*call, observers_);  // gRPC deletes it
  }

 private:
  const CallObservers observers_;
};

}  // namespace

std::unique_ptr<grpc::experimental::ServerInterceptorFactoryInterface> observe_calls(const CallObservers& observers) {
  return std::make_unique<ObserverFactory>(observers);
}

}  // namespace dualarm
