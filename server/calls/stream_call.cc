#include "server/calls/stream_call.h"

#include <algorithm>
#include <utility>

#include "server/errors.h"
#include "server/response/plan.h"

namespace dualarm {
namespace {

// A reader who is that far behind gets the newest of them only: each is better than all before.
constexpr std::size_t kMostUnsentPlans = 16;

}  // namespace

grpc::ServerWriteReactor<wire::PlanMotionStreamResponse>* StreamCall::start(
    const Planner& planner, Ticker& ticker, Places& places, const grpc::CallbackServerContext& context,
    const wire::PlanMotionStreamRequest& request) {
  auto* call = new StreamCall(planner, ticker, places, context, request);  // deleted by OnDone
  if (!call->place_) {
    call->finish({too_many_streams(), "too many streams"});
  } else {
    ticker.add(*call);
    call->task_.start();
  }
  return call;
}

StreamCall::StreamCall(const Planner& planner, Ticker& ticker, Places& places,
                       const grpc::CallbackServerContext& context, const wire::PlanMotionStreamRequest& request)
    : caller_("PlanMotionStream", context),
      ticker_(ticker),
      place_(places.take()),
      task_(planner, caller_, request.request(), response_, WhenFull::kRefuse,
            [this](const Answer& answer) { finish(answer); },
            {[this](const PlanningStatus& status) { hear(status); }, [this](const Plan& plan) { hear(plan); }}),
      pace_(caller_.since()) {}

void StreamCall::tick(Ticker::Clock::time_point now) {
  std::unique_lock lock(mutex_);
  if (!pace_.is_due(now, has_news_)) return;
  is_progress_due_ = true;
  go_on(std::move(lock));
}

void StreamCall::hear(const PlanningStatus& status) {
  const std::lock_guard lock(mutex_);
  phase_ = status.phase;
  lower_bound_ = status.lower_bound;
  evaluation_count_ = status.fallback_evaluation_count;
  has_news_ = true;
}

void StreamCall::hear(const Plan& plan) {
  wire::PlanMotionStreamResponse event;
  *event.mutable_incumbent() = plan_message(plan);
  std::unique_lock lock(mutex_);
  best_duration_ = plan.duration;
  lower_bound_ = std::max(lower_bound_, plan.certificate.lower_bound);
  plans_.push_back(std::move(event));
  if (plans_.size() > kMostUnsentPlans) plans_.pop_front();
  go_on(std::move(lock));
}

void StreamCall::finish(const Answer& answer) {
  ticker_.remove(*this);
  caller_.log(answer);
  std::unique_lock lock(mutex_);
  end_ = answer.status;
  go_on(std::move(lock));  // the call may be gone from here on
}

void StreamCall::OnWriteDone(bool ok) {
  std::unique_lock lock(mutex_);
  is_busy_ = false;
  is_broken_ = !ok;
  go_on(std::move(lock));
}

// The lock comes from whoever changed what this acts on: between two locks others could act on it and end the call.
void StreamCall::go_on(std::unique_lock<std::mutex> lock) {
  if (is_busy_) return;
  const Step step = next_step();
  is_busy_ = step != Step::kNothing;
  const grpc::Status status = end_ ? *end_ : grpc::Status();
  lock.unlock();
  // Without the lock: gRPC may end the call, and with it the lock, before these return. Nobody else comes this far.
  if (step == Step::kWrite) StartWrite(&event_);
  if (step == Step::kWriteLast) StartWriteAndFinish(&event_, {}, status);
  if (step == Step::kFinish) Finish(status);
}

StreamCall::Step StreamCall::next_step() {
  const bool is_heard = !is_broken_ && !caller_.has_left();
  if (is_heard && !plans_.empty()) {
    event_ = std::move(plans_.front());
    plans_.pop_front();
    return Step::kWrite;
  }
  if (end_ && end_->ok() && is_heard) {
    *event_.mutable_outcome() = std::move(response_);
    return Step::kWriteLast;
  }
  if (end_) {
    if (end_->ok()) end_ = cancelled();
    return Step::kFinish;
  }
  if (is_heard && is_progress_due_) {
    take_progress();
    return Step::kWrite;
  }
  return Step::kNothing;
}

void StreamCall::take_progress() {
  const auto now = ProgressPace::Clock::now();
  wire::Progress& progress = *event_.mutable_progress();
  progress.Clear();
  progress.set_elapsed_s(std::chrono::duration<double>(now - caller_.since()).count());
  progress.set_phase(phase_);
  if (best_duration_) progress.set_best_duration_s(*best_duration_);
  progress.set_lower_bound_s(lower_bound_);
  progress.set_fallback_evaluation_count(evaluation_count_);
  pace_.told(now);
  has_news_ = false;
  is_progress_due_ = false;
}

}  // namespace dualarm
