#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <mutex>

#include "server/calls/answer.h"
#include "server/calls/caller.h"
#include "server/calls/places.h"
#include "server/calls/planning_task.h"
#include "server/calls/request_ids.h"
#include "server/calls/ticker.h"
#include "server/planning_methods.h"

namespace dualarm {

/// One call of PlanMotionBatch. A request is in flight from when it is read until its answer is handed to the network.
/// The next one is read only while fewer than a limit are in flight: a reader who is slow to take answers stops the
/// reading and the computing. Where the server drains, what was read is answered and the call ends.
class BatchCall final : public BatchReactor, private Ticker::Listener {
 public:
  /// What all batches of a server share; outlives them.
  struct Setting {
    const Planner& planner;
    Ticker& ticker;
    Places& places;
    int in_flight = 1;                ///< requests of one batch, at least 1
    const std::atomic<bool>& drains;  ///< the server reads no more requests
  };

  /// The reactor owns itself.
  static BatchReactor* start(const Setting& setting, const grpc::CallbackServerContext& context);

 private:
  /// One request of the stream; deletes itself when it is answered.
  class Item;

  BatchCall(const Setting& setting, const grpc::CallbackServerContext& context);

  void OnCancel() override { caller_.leave(); }
  void OnReadDone(bool ok) override;
  void OnWriteDone(bool ok) override;
  void OnDone() override;
  void tick(Ticker::Clock::time_point now) override;

  /// Takes up the request that was read.
  void take_up();
  void send(wire::PlanMotionBatchResponse response, const Answer& answer);

  /// Reads, writes or ends the call, whatever is possible now.
  void go_on(std::unique_lock<std::mutex> lock);
  bool begins_reading();
  bool begins_writing();
  bool ends() const;

  const Setting setting_;
  Caller caller_;
  Place place_;
  RequestIds ids_;             // only where a read ends
  grpc::ByteBuffer incoming_;  // being read

  std::mutex mutex_;  // of everything below
  int in_flight_ = 0;
  int starting_ = 0;  // threads that are about to start what they have begun
  std::deque<wire::PlanMotionBatchResponse> unsent_;
  wire::PlanMotionBatchResponse outgoing_;  // being written
  bool is_reading_ = false;
  bool is_writing_ = false;
  bool is_read_to_the_end_ = false;
  bool is_broken_ = false;  // no answer arrives any more
  bool has_ended_ = false;
  std::int64_t answered_count_ = 0;
  std::int64_t error_count_ = 0;  // of them
  Caller::Clock::duration waited_{};
};

}  // namespace dualarm
