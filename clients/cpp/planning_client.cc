#include "clients/cpp/planning_client.h"

#include <google/protobuf/wrappers.pb.h>
#include <grpcpp/generic/generic_stub.h>

#include <chrono>
#include <future>
#include <thread>
#include <utility>

#include "clients/cpp/command_error.h"
#include "clients/cpp/secure_channel.h"

namespace dualarm {
namespace {

using namespace planning::v1;

constexpr auto kStartTimeout = std::chrono::seconds(5);  // from the first connection to SERVING

}  // namespace

PlanningClient::PlanningClient(const ConnectionOptions& options, std::stop_token stop)
    : server_name_(options.server), timeout_s_(options.timeout_s), stop_(std::move(stop)) {
  if (options.server.empty()) {
    local_server_.emplace(stop_);
    server_name_ = "the private dualarm-server";
  }
  token_ = token_for(options);
  channel_ = open_channel(local_server_ ? local_server_->address() : options.server, options);
  stub_ = PlanningService::NewStub(channel_);
  if (local_server_) wait_until_serving();
}

PlanningClient::~PlanningClient() = default;

void PlanningClient::wait_until_serving() const {
  const auto deadline = std::chrono::steady_clock::now() + kStartTimeout;
  while (!is_serving(PlanningService::service_full_name())) {
    if (std::chrono::steady_clock::now() > deadline) {
      throw CommandError(ExitStatus::kUnreachable, server_name_ + " has started but does not serve");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void PlanningClient::prepare(grpc::ClientContext& context) const {
  if (!token_.empty()) context.AddMetadata("authorization", "Bearer " + token_);
  context.set_deadline(std::chrono::system_clock::now() +
                       std::chrono::microseconds(static_cast<std::int64_t>(1e6 * timeout_s_)));
}

template <typename Response, typename Send>
Response PlanningClient::call(Send send) const {
  grpc::ClientContext context;
  prepare(context);
  const std::stop_callback cancel(stop_, [&context] { context.TryCancel(); });
  Response response;
  const grpc::Status status = send(&context, &response);
  if (!status.ok()) throw error_of_call(status, server_name_);
  return response;
}

PlanMotionResponse PlanningClient::plan(const PlanMotionRequest& request) const {
  return call<PlanMotionResponse>(
      [&](auto* context, auto* response) { return stub_->PlanMotion(context, request, response); });
}

PlanMotionResponse PlanningClient::plan(const PlanMotionRequest& request,
                                        const std::function<void(const PlanMotionStreamResponse&)>& hear) const {
  PlanMotionStreamRequest streamed;
  *streamed.mutable_request() = request;
  return call<PlanMotionResponse>([&](grpc::ClientContext* context, PlanMotionResponse* response) {
    const auto stream = stub_->PlanMotionStream(context, streamed);
    for (PlanMotionStreamResponse event; stream->Read(&event);) {
      if (event.has_outcome()) {
        *response = std::move(*event.mutable_outcome());
      } else {
        hear(event);
      }
    }
    return stream->Finish();
  });
}

void PlanningClient::plan_batch(const std::function<std::optional<PlanMotionBatchRequest>()>& next,
                                const std::function<void(const PlanMotionBatchResponse&)>& answer) const {
  grpc::ClientContext context;
  prepare(context);
  const std::stop_callback cancel(stop_, [&context] { context.TryCancel(); });
  const auto stream = stub_->PlanMotionBatch(&context);
  auto sent = std::async(std::launch::async, [&] {
    try {
      for (auto request = next(); request && stream->Write(*request);) request = next();
      stream->WritesDone();
    } catch (...) {
      context.TryCancel();
      throw;
    }
  });
  try {
    for (PlanMotionBatchResponse response; stream->Read(&response);) answer(response);
  } catch (...) {
    context.TryCancel();  // else the other thread would wait for room that nobody makes
    throw;
  }
  const grpc::Status status = stream->Finish();
  sent.get();
  if (!status.ok()) throw error_of_call(status, server_name_);
}

VerifyMotionResponse PlanningClient::verify(const VerifyMotionRequest& request) const {
  return call<VerifyMotionResponse>(
      [&](auto* context, auto* response) { return stub_->VerifyMotion(context, request, response); });
}

GetForbiddenRegionResponse PlanningClient::forbidden_region(const GetForbiddenRegionRequest& request) const {
  return call<GetForbiddenRegionResponse>(
      [&](auto* context, auto* response) { return stub_->GetForbiddenRegion(context, request, response); });
}

GetPhasePortraitResponse PlanningClient::phase_portrait(const GetPhasePortraitRequest& request) const {
  return call<GetPhasePortraitResponse>(
      [&](auto* context, auto* response) { return stub_->GetPhasePortrait(context, request, response); });
}

// grpc.health.v1 in well-known wrappers, which are the same bytes, so that the client needs no generated health code:
// HealthCheckRequest is one string, field 1; HealthCheckResponse is one enum, field 1, in which SERVING is 1.
bool PlanningClient::is_serving(const std::string& service) const {
  using google::protobuf::Int32Value;
  using google::protobuf::StringValue;
  StringValue request;
  request.set_value(service);
  grpc::TemplatedGenericStub<StringValue, Int32Value> health(channel_);
  const auto answer = call<Int32Value>([&](auto* context, auto* response) {
    std::promise<grpc::Status> status;
    health.UnaryCall(context, "/grpc.health.v1.Health/Check", {}, &request, response,
                     [&status](grpc::Status outcome) { status.set_value(std::move(outcome)); });
    const grpc::Status outcome = status.get_future().get();
    // A service that the server does not know (yet) is not serving: no error, and the answer is UNKNOWN.
    return outcome.error_code() == grpc::StatusCode::NOT_FOUND ? grpc::Status::OK : outcome;
  });
  return answer.value() == 1;
}

}  // namespace dualarm
