#pragma once

#include <google/protobuf/message.h>
#include <grpcpp/support/server_callback.h>

#include <functional>
#include <string_view>

#include "server/calls/answer.h"
#include "server/calls/caller.h"
#include "server/calls/planning_task.h"
#include "server/pools/worker_pool.h"

namespace dualarm {

/// One unary RPC but PlanMotion: waits for a worker, computes there, logs one line, answers once.
class UnaryCall final : public grpc::ServerUnaryReactor {
 public:
  /// Reads the request, fills the response, and says how it went.
  using Work = std::function<Answer(const Caller&)>;

  /// Hands the work to the pool, or refuses it if the pool is full. The reactor owns itself.
  static grpc::ServerUnaryReactor* start(WorkerPool& pool, std::string_view rpc,
                                         const grpc::CallbackServerContext& context,
                                         const google::protobuf::Message& request, Work work);

 private:
  UnaryCall(std::string_view rpc, const grpc::CallbackServerContext& context, const google::protobuf::Message& request,
            Work work);

  void OnCancel() override { caller_.leave(); }
  void OnDone() override { delete this; }

  void run();
  Answer answer() const;
  void finish(const Answer& answer);

  Caller caller_;
  const google::protobuf::Message& request_;
  Work work_;
};

/// One call of PlanMotion.
class PlanCall final : public grpc::ServerUnaryReactor {
 public:
  /// The reactor owns itself.
  static grpc::ServerUnaryReactor* start(const Planner& planner, const grpc::CallbackServerContext& context,
                                         const wire::PlanMotionRequest& request, wire::PlanMotionResponse& response);

 private:
  PlanCall(const Planner& planner, const grpc::CallbackServerContext& context, const wire::PlanMotionRequest& request,
           wire::PlanMotionResponse& response);

  void OnCancel() override { caller_.leave(); }
  void OnDone() override { delete this; }

  Caller caller_;
  PlanningTask task_;
};

}  // namespace dualarm
