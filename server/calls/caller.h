#pragma once

#include <grpcpp/support/server_callback.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <string_view>

#include "core/model/budget.h"
#include "server/calls/answer.h"

namespace dualarm {

/// Whoever waits for a call's answer: since when, until when, and whether still. Every kind of call has one. It gives
/// the call's computations their budget and writes the call's line into the log.
class Caller {
 public:
  using Clock = Budget::Clock;

  Caller(std::string_view rpc, const grpc::CallbackServerContext& context);

  std::string_view rpc() const { return rpc_; }
  Clock::time_point since() const { return since_; }

  /// The caller cancelled, went away, or its deadline passed. From any thread.
  void leave() { has_left_ = true; }
  bool has_left() const { return has_left_; }

  /// For a computation of at most this long from now on, which ends a little before the caller's deadline and as soon
  /// as the caller has left. Valid as long as this object.
  Budget budget(std::chrono::nanoseconds at_most) const;

  /// The same, which ends also as soon as `over` says so.
  Budget budget(std::chrono::nanoseconds at_most, std::function<bool()> over) const;

  /// One line about the call, which ends with this answer.
  void log(const Answer& answer) const;

 private:
  std::string_view rpc_;
  Clock::time_point since_ = Clock::now();
  Clock::time_point until_;
  std::atomic<bool> has_left_ = false;
};

}  // namespace dualarm
