#pragma once

#include <cstdint>
#include <deque>
#include <mutex>

#include "server/answer.h"
#include "server/caller.h"
#include "server/places.h"
#include "server/planning_methods.h"
#include "server/planning_task.h"
#include "server/request_ids.h"

namespace dualarm {

/// One call of PlanMotionBatch. A request is in flight from when it is read until its answer is handed to the network.
/// The next one is read only while fewer than a limit are in flight: a reader who is slow to take answers stops the
/// reading and the computing.
class BatchCall final : public BatchReactor {
 public:
  /// The reactor owns itself. in_flight >= 1.
  static BatchReactor* start(const Planner& planner, Places& places, int in_flight,
                             const grpc::CallbackServerContext& context);

 private:
  /// One request of the stream; deletes itself when it is answered.
  class Item;

  BatchCall(const Planner& planner, Places& places, int in_flight, const grpc::CallbackServerContext& context);

  void OnCancel() override { caller_.leave(); }
  void OnReadDone(bool ok) override;
  void OnWriteDone(bool ok) override;
  void OnDone() override { delete this; }

  /// Takes up the request that was read.
  void take_up();
  void send(wire::PlanMotionBatchResponse response, const Answer& answer);

  /// Reads, writes or ends the call, whatever is possible now.
  void go_on();
  bool begins_reading();
  bool begins_writing();
  bool ends();

  const Planner& planner_;
  const int most_in_flight_;
  Caller caller_;
  Place place_;
  RequestIds ids_;             // only where a read ends
  grpc::ByteBuffer incoming_;  // being read

  std::mutex mutex_;  // of everything below
  int in_flight_ = 0;
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
