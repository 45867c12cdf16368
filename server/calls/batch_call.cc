#include "server/calls/batch_call.h"

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
        task_(call.setting_.planner, call.caller_, request_.request(), planned_, WhenFull::kWait,
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

BatchReactor* BatchCall::start(const Setting& setting, const grpc::CallbackServerContext& context) {
  auto* call = new BatchCall(setting, context);  // deleted by OnDone
  if (call->place_) {
    setting.ticker.add(*call);
    call->go_on(std::unique_lock(call->mutex_));
  } else {
    const Answer refused = {too_many_streams(), "too many streams"};
    call->caller_.log(refused);
    call->Finish(refused.status);
  }
  return call;
}

BatchCall::BatchCall(const Setting& setting, const grpc::CallbackServerContext& context)
    : setting_(setting), caller_("PlanMotionBatch", context), place_(setting.places.take()) {}

void BatchCall::OnDone() {
  setting_.ticker.remove(*this);
  delete this;
}

// The client may be silent for ever: nothing else tells the call that the server drains.
void BatchCall::tick(Ticker::Clock::time_point /*now*/) {
  if (setting_.drains) go_on(std::unique_lock(mutex_));
}

void BatchCall::OnReadDone(bool ok) {
  if (ok) take_up();
  std::unique_lock lock(mutex_);
  is_reading_ = false;
  is_read_to_the_end_ = !ok;
  go_on(std::move(lock));
}

void BatchCall::take_up() {
  {
    const std::lock_guard lock(mutex_);
    if (has_ended_) return;  // it came while the call ended because the server drains
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
  std::unique_lock lock(mutex_);
  ++answered_count_;
  error_count_ += answer.status.ok() ? 0 : 1;
  waited_ += answer.waited;
  if (is_broken_) {
    --in_flight_;
  } else {
    unsent_.push_back(std::move(response));
  }
  go_on(std::move(lock));  // the call may be gone from here on
}

void BatchCall::OnWriteDone(bool ok) {
  std::unique_lock lock(mutex_);
  is_writing_ = false;
  --in_flight_;
  if (!ok) {
    is_broken_ = true;
    in_flight_ -= static_cast<int>(unsent_.size());
    unsent_.clear();
  }
  go_on(std::move(lock));
}

// gRPC is called without the lock: it may call back, or end the call and with it the lock. Whoever is about to start
// something keeps the others from ending the call. The lock comes from whoever changed what this acts on: between two
// locks others could act on it and end the call.
void BatchCall::go_on(std::unique_lock<std::mutex> lock) {
  for (;;) {
    const bool reads = begins_reading();
    const bool writes = begins_writing();
    if (!reads && !writes) break;
    ++starting_;
    lock.unlock();
    if (writes) StartWrite(&outgoing_);
    if (reads) StartRead(&incoming_);
    lock.lock();
    --starting_;
  }
  if (!ends()) return;
  has_ended_ = true;
  const grpc::Status status = is_read_to_the_end_ ? grpc::Status::OK : draining();
  const Answer end = {caller_.has_left() ? cancelled() : status,
                      fmt::format("{} answered, {} of them by errors", answered_count_, error_count_), waited_};
  lock.unlock();
  caller_.log(end);
  Finish(end.status);  // the call may be gone from here on
}

bool BatchCall::begins_reading() {
  if (is_reading_ || is_read_to_the_end_ || in_flight_ >= setting_.in_flight || setting_.drains) return false;
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

bool BatchCall::ends() const {
  const bool reads_no_more = setting_.drains || (is_read_to_the_end_ && !is_reading_);
  return reads_no_more && !is_writing_ && in_flight_ == 0 && starting_ == 0 && !has_ended_;
}

}  // namespace dualarm
