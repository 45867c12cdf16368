#pragma once

#include <grpcpp/support/server_callback.h>

#include <deque>
#include <mutex>
#include <optional>
#include <string>

#include "server/calls/answer.h"
#include "server/calls/caller.h"
#include "server/calls/places.h"
#include "server/calls/planning_task.h"
#include "server/calls/progress_pace.h"
#include "server/calls/ticker.h"

namespace dualarm {

/// One call of PlanMotionStream: progress, each better plan as soon as it is found, one outcome at the end. One event
/// is on its way at a time; what comes meanwhile waits in the call: the latest progress, the latest plans, the outcome.
/// A slow reader therefore hears less progress, and costs no more memory than a fast one.
class StreamCall final : public grpc::ServerWriteReactor<wire::PlanMotionStreamResponse>, private Ticker::Listener {
 public:
  /// The reactor owns itself.
  static grpc::ServerWriteReactor<wire::PlanMotionStreamResponse>* start(const Planner& planner, Ticker& ticker,
                                                                         Places& places,
                                                                         const grpc::CallbackServerContext& context,
                                                                         const wire::PlanMotionStreamRequest& request);

 private:
  StreamCall(const Planner& planner, Ticker& ticker, Places& places, const grpc::CallbackServerContext& context,
             const wire::PlanMotionStreamRequest& request);

  void OnCancel() override { caller_.leave(); }
  void OnWriteDone(bool ok) override;
  void OnDone() override { delete this; }

  void tick(Ticker::Clock::time_point now) override;
  void hear(const PlanningStatus& status);
  void hear(const Plan& plan);
  void finish(const Answer& answer);

  /// Sends what is next, if nothing is on its way. `lock` holds the mutex.
  void go_on(std::unique_lock<std::mutex> lock);

  enum class Step { kNothing, kWrite, kWriteLast, kFinish };
  Step next_step();
  void take_progress();

  Caller caller_;
  Ticker& ticker_;
  Place place_;
  wire::PlanMotionResponse response_;
  PlanningTask task_;

  std::mutex mutex_;  // of everything below
  ProgressPace pace_;
  std::string phase_ = "waiting for a worker";
  double lower_bound_ = 0.0;  // s
  int evaluation_count_ = 0;
  std::optional<double> best_duration_;  // s
  bool has_news_ = false;
  bool is_progress_due_ = false;
  std::deque<wire::PlanMotionStreamResponse> plans_;  // to be sent
  std::optional<grpc::Status> end_;
  bool is_busy_ = false;                  // an event is on its way, or the call has ended
  bool is_broken_ = false;                // nothing arrives any more
  wire::PlanMotionStreamResponse event_;  // on its way
};

}  // namespace dualarm
