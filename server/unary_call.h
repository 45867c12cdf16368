#pragma once

#include <google/protobuf/message.h>
#include <grpcpp/support/server_callback.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <string_view>

#include "core/model/budget.h"
#include "server/worker_pool.h"

namespace dualarm {

/// How a call ended, with a few words for the log.
struct Answer {
  grpc::Status status;
  std::string note;
};

/// One unary RPC: waits for a worker, computes there, logs one line, answers once. This is the one outer wrapper: what
/// the work throws becomes INTERNAL, with an id under which the log holds the request. A caller that cancels or whose
/// deadline passes makes the budget exhausted.
class UnaryCall final : public grpc::ServerUnaryReactor {
 public:
  /// Reads the request, fills the response, and says how it went.
  using Work = std::function<Answer(const UnaryCall&)>;

  /// Hands the work to the pool, or refuses it if the pool is full. The reactor owns itself.
  static grpc::ServerUnaryReactor* start(WorkerPool& pool, std::string_view rpc,
                                         const grpc::CallbackServerContext& context,
                                         const google::protobuf::Message& request, Work work);

  /// For at most this long from now, and a little less than the caller waits. Only valid while the call runs.
  Budget budget(std::chrono::nanoseconds at_most) const;

  bool cancelled() const { return cancelled_; }

 private:
  using Clock = std::chrono::steady_clock;

  UnaryCall(std::string_view rpc, const grpc::CallbackServerContext& context, const google::protobuf::Message& request,
            Work work);

  void OnCancel() override { cancelled_ = true; }
  void OnDone() override { delete this; }

  void run();
  Answer answer() const;
  Answer answer_to_exception(std::string_view what) const;
  void finish(const Answer& answer);

  std::string_view rpc_;
  const google::protobuf::Message& request_;
  Work work_;
  Clock::time_point received_ = Clock::now();
  Clock::time_point started_ = received_;
  Clock::time_point caller_waits_until_;
  std::atomic<bool> cancelled_ = false;
};

}  // namespace dualarm
