// Calls of the planning service, each with a deadline, cancelled when a stop is requested.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "clients/cpp/connection_options.h"
#include "clients/cpp/local_server.h"
#include "dualarm/planning/v1/planning_service.grpc.pb.h"

namespace dualarm {

/// Every call throws the CommandError of error_of_call() where the server does not answer with a message.
class PlanningClient {
 public:
  /// Starts a LocalServer where options.server is empty, and waits until it serves. Else connects with the first call.
  PlanningClient(const ConnectionOptions& options, std::stop_token stop);
  ~PlanningClient();

  planning::v1::PlanMotionResponse plan(const planning::v1::PlanMotionRequest& request) const;

  /// The same through PlanMotionStream; `hear` is called with each event but the outcome.
  planning::v1::PlanMotionResponse plan(
      const planning::v1::PlanMotionRequest& request,
      const std::function<void(const planning::v1::PlanMotionStreamResponse&)>& hear) const;

  /// Sends what `next` gives until it gives nothing, on a thread of its own; `answer` is called with each answer as it
  /// comes. Each request of `next` has been answered when this returns.
  void plan_batch(const std::function<std::optional<planning::v1::PlanMotionBatchRequest>()>& next,
                  const std::function<void(const planning::v1::PlanMotionBatchResponse&)>& answer) const;

  planning::v1::VerifyMotionResponse verify(const planning::v1::VerifyMotionRequest& request) const;
  planning::v1::GetForbiddenRegionResponse forbidden_region(
      const planning::v1::GetForbiddenRegionRequest& request) const;
  planning::v1::GetPhasePortraitResponse phase_portrait(const planning::v1::GetPhasePortraitRequest& request) const;

  /// Whether grpc.health.v1 says that `service` is serving; the empty name asks for the server as a whole. A service
  /// that the server does not know is not serving.
  bool is_serving(const std::string& service) const;

  /// "127.0.0.1:50051", or what stands for the private server.
  const std::string& server_name() const { return server_name_; }

 private:
  void wait_until_serving() const;

  void prepare(grpc::ClientContext& context) const;

  /// The answer of `send`(context, response), or its error.
  template <typename Response, typename Send>
  Response call(Send send) const;

  std::optional<LocalServer> local_server_;
  std::string server_name_;
  double timeout_s_;
  std::string token_;  // "" for none
  std::stop_token stop_;
  std::shared_ptr<grpc::Channel> channel_;
  std::unique_ptr<planning::v1::PlanningService::Stub> stub_;
};

}  // namespace dualarm
