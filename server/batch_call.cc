#include "server/batch_call.h"

#include <fmt/format.h>
#include <grpcpp/impl/codegen/proto_utils.h>

#include <memory>
#include <utility>

#include "google/rpc/status.pb.h"
#include "server/errors.h"

namespace dualarm {
namespace {

// As PlanMotion would have sent it; the details were made by errors.cc and parse.
google::rpc::Status error_message(const grpc::Status& status) {
  google::rpc::Status error;
  error.ParseFromString(status.error_details());
  error.set_code(status.error_code());
  error.set_message(status.error_message());
  return error;
}

}  // namespace

class BatchCall::Item {
 public:
  Item(BatchCall& call, wire::PlanMotionBatchRequest request)
      : call_(call),
        request_(std::move(request)),
        task_(call.planner_, call.caller_, request_.request(), planned_, WhenFull::kWait,
              [this](const Answer& answer) { finish(answer); }) {}

  const wire::PlanMotionBatchRequest& request() const { return request_; }
  void start() { task_.start(); }

  void finish(const Answer& answer) {
    const std::unique_ptr<Item> self(this);
    wire::PlanMotionBatchResponse response;
    response.set_request_id(repeated_id(request_.request_id()));
    if (answer.status.ok()) {
      *response.mutable_response() = std::move(planned_);
    } else {
      *response.mutable_error() = error_message(answer.status);
    }
    call_.send(std::move(response), answer);
  }

 private:
  BatchCall& call_;
  wire::PlanMotionBatchRequest request_;
  wire::PlanMotionResponse planned_;
  PlanningTask task_;
};

BatchReactor* BatchCall::start(const Planner& planner, Places& places, int in_flight,
                               const grpc::CallbackServerContext& context) {
  auto* call = new BatchCall(planner, places, in_flight, context);  // deleted by OnDone
  if (call->place_) {
    call->go_on();
  } else {
    const Answer refused = {too_many_streams(), "too many streams"};
    call->caller_.log(refused);
    call->Finish(refused.status);
  }
  return call;
}

BatchCall::BatchCall(const Planner& planner, Places& places, int in_flight, const grpc::CallbackServerContext& context)
    : planner_(planner), most_in_flight_(in_flight), caller_("PlanMotionBatch", context), place_(places.take()) {}

void BatchCall::OnReadDone(bool ok) {
  if (ok) take_up();
  {
    const std::lock_guard lock(mutex_);
    is_reading_ = false;
    is_read_to_the_end_ = !ok;
  }
  go_on();
}

void BatchCall::take_up() {
  {
    const std::lock_guard lock(mutex_);
    ++in_flight_;
  }
  wire::PlanMotionBatchRequest request;
  const bool is_message =
      grpc::SerializationTraits<wire::PlanMotionBatchRequest>::Deserialize(&incoming_, &request).ok();
  incoming_.Clear();
  auto* item = new Item(*this, std::move(request));  // deletes itself
  if (!is_message) {
    item->finish({malformed_request(item->request().GetTypeName()), "malformed"});
  } else if (const auto complaint = ids_.complaint_about(item->request().request_id())) {
    item->finish(*complaint);
  } else {
    item->start();
  }
}

void BatchCall::send(wire::PlanMotionBatchResponse response, const Answer& answer) {
  {
    const std::lock_guard lock(mutex_);
    ++answered_count_;
    error_count_ += answer.status.ok() ? 0 : 1;
    waited_ += answer.waited;
    if (is_broken_) {
      --in_flight_;
    } else {
      unsent_.push_back(std::move(response));
    }
  }
  go_on();  // the call may be gone from here on
}

void BatchCall::OnWriteDone(bool ok) {
  {
    const std::lock_guard lock(mutex_);
    is_writing_ = false;
    --in_flight_;
    if (!ok) {
      is_broken_ = true;
      in_flight_ -= static_cast<int>(unsent_.size());
      unsent_.clear();
    }
  }
  go_on();
}

void BatchCall::go_on() {
  bool reads = false;
  bool writes = false;
  bool ends_now = false;
  Answer end;
  {
    const std::lock_guard lock(mutex_);
    reads = begins_reading();
    writes = begins_writing();
    ends_now = ends();
    if (ends_now) {
      end = {caller_.has_left() ? cancelled() : grpc::Status::OK,
             fmt::format("{} answered, {} of them by errors", answered_count_, error_count_), waited_};
    }
  }
  // Without the lock: gRPC may end the call, and with it the lock, before the last of these returns.
  if (writes) StartWrite(&outgoing_);
  if (reads) StartRead(&incoming_);
  if (ends_now) {
    caller_.log(end);
    Finish(end.status);
  }
}

bool BatchCall::begins_reading() {
  if (is_reading_ || is_read_to_the_end_ || in_flight_ >= most_in_flight_) return false;
  is_reading_ = true;
  return true;
}

bool BatchCall::begins_writing() {
  if (is_writing_ || unsent_.empty()) return false;
  outgoing_ = std::move(unsent_.front());
  unsent_.pop_front();
  is_writing_ = true;
  return true;
}

bool BatchCall::ends() {
  if (!is_read_to_the_end_ || is_reading_ || is_writing_ || in_flight_ > 0 || has_ended_) return false;
  has_ended_ = true;
  return true;
}

}  // namespace dualarm
