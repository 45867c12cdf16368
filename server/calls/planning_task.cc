#include "server/calls/planning_task.h"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <utility>

#include "server/errors.h"
#include "server/logging/logs.h"
#include "server/response/responses.h"

namespace dualarm {
namespace {

/// The part of what is left of the budget for which a plan in hand waits for its search: one in so many.
constexpr int kShareOfPatience = 2;

/// Processor time for which a worker for short plans tries one. Most take a tenth of that.
constexpr std::chrono::milliseconds kTrialOfWorker{5};

std::chrono::nanoseconds work_of_this_thread() {
  timespec time = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

std::string note_on(const wire::PlanMotionResponse& response) {
  switch (response.outcome_case()) {
    case wire::PlanMotionResponse::kPlan:
      return fmt::format("plan {} duration_s={:.6f} gap={:.2e}", wire::Method_Name(response.plan().method()),
                         response.plan().duration_s(), response.plan().certificate().gap());
    case wire::PlanMotionResponse::kInfeasible:
      return fmt::format("infeasible {}", wire::Reason_Name(response.infeasible().reason()));
    case wire::PlanMotionResponse::kUndecided:
      return "undecided";
    case wire::PlanMotionResponse::OUTCOME_NOT_SET:
      break;
  }
  return "valid";
}

}  // namespace

PlanningTask::PlanningTask(const Planner& planner, const Caller& caller, const wire::PlanMotionRequest& request,
                           wire::PlanMotionResponse& response, WhenFull when_full, Done done, Observer observer)
    : planner_(planner),
      caller_(caller),
      request_(request),
      response_(response),
      when_full_(when_full),
      done_(std::move(done)),
      observer_(std::move(observer)) {}

void PlanningTask::start() {
  // A trial would tell those who watch of the same plans again.
  if (observer_.on_status || observer_.on_incumbent) return start_slowly();
  if (!submit(planner_.pools.quick, &PlanningTask::begin)) finish({overloaded(), "queue full"});
}

void PlanningTask::start_here() {
  if (planner_.trial == std::chrono::nanoseconds::zero()) return start();
  const Place place = planner_.trials.take();
  if (!place) return start();
  if (!go_on_within(planner_.trial)) start_slowly();
}

void PlanningTask::start_slowly() {
  if (!submit(planner_.pools.slow, &PlanningTask::begin_slowly)) finish({overloaded(), "queue full"});
}

bool PlanningTask::submit(WorkerPool& pool, void (PlanningTask::*step)()) {
  submitted_ = Clock::now();
  WorkerPool::Task task = [this, step] {
    waited_ += Clock::now() - submitted_;
    (this->*step)();
  };
  if (when_full_ == WhenFull::kRefuse) return pool.try_submit(std::move(task));
  pool.submit(std::move(task));
  return true;
}

void PlanningTask::begin() {
  if (!go_on_within(kTrialOfWorker)) start_slowly();
}

void PlanningTask::begin_slowly() {
  go_on(answer_of(caller_.rpc(), request_, [this] { return plan_quickly(); }));
}

bool PlanningTask::go_on_within(std::chrono::nanoseconds work) {
  trial_ = {Clock::now() + work, work_of_this_thread() + work};
  std::optional<Answer> answer = answer_of(caller_.rpc(), request_, [this] { return plan_quickly(); });
  if (!trial_->is_over) {
    go_on(std::move(answer));
    return true;
  }
  steps_.reset();
  trial_.reset();
  return false;
}

// Once it is handed to the search, the search may have come and gone: nothing of this is touched then.
void PlanningTask::go_on(std::optional<Answer> quick) {
  if (quick) return finish(*std::move(quick));
  if (caller_.has_left()) return finish(gone("before the search"));
  if (const auto in_hand = steps_->in_hand(); in_hand && when_full_ == WhenFull::kRefuse) {
    return wait_for_search(*in_hand);
  }
  if (!submit(planner_.pools.search, &PlanningTask::resume)) finish({searches_overloaded(), "search queue full"});
}

// Waiting takes from the budget here: what is left when patience ends is for the answer, or for a search that is late.
void PlanningTask::wait_for_search(const Outcome& in_hand) {
  const auto wait = std::make_shared<Wait>(in_hand, caller_.budget(budget_left_ / kShareOfPatience));
  wait_ = wait;
  submitted_ = Clock::now();
  planner_.ticker.add(*this);
  const bool is_queued = planner_.pools.search.try_submit([this, wait] {
    if (wait->is_over.exchange(true)) return;  // the task may be gone
    budget_left_ -= end_wait();
    resume();
  });
  if (is_queued || wait->is_over.exchange(true)) return;
  end_wait();
  answer_in_hand();
}

void PlanningTask::tick(Ticker::Clock::time_point /*now*/) {
  if (!wait_->patience.exhausted() || wait_->is_over.exchange(true)) return;
  planner_.pools.quick.submit([this] {
    end_wait();
    answer_in_hand();
  });
}

PlanningTask::Clock::duration PlanningTask::end_wait() {
  planner_.ticker.remove(*this);
  const auto waited = Clock::now() - submitted_;
  waited_ += waited;
  return waited;
}

void PlanningTask::answer_in_hand() {
  finish(answer_of(caller_.rpc(), request_, [this] { return answer(wait_->in_hand); }));
}

void PlanningTask::resume() {
  finish(answer_of(caller_.rpc(), request_, [this] { return search(); }));
}

std::optional<Answer> PlanningTask::plan_quickly() {
  if (caller_.has_left()) return gone("before it began");
  Parsed<PlanWish> parsed = parse(request_, planner_.limits);
  if (const auto* violations = std::get_if<Violations>(&parsed)) return refusal(*violations);
  wish_ = std::get<PlanWish>(std::move(parsed));
  wish_.problem.options.search_memory = planner_.search_memory;
  if (wish_.validate_only) return Answer{grpc::Status::OK, note_on(response_)};

  const auto begin = Clock::now();
  const auto allowed = std::min(wish_.budget.value_or(planner_.longest), planner_.longest);
  steps_ = planner_.functions.begin_planning(wish_.problem, quick_budget(allowed), observer_);
  const auto outcome = steps_->quick();
  if (trial_ && trial_->is_over) return std::nullopt;
  if (outcome) return answer(*outcome);
  budget_left_ = allowed - (Clock::now() - begin);
  return std::nullopt;
}

Budget PlanningTask::quick_budget(std::chrono::nanoseconds at_most) {
  if (!trial_) return caller_.budget(at_most);
  return caller_.budget(at_most, [this] { return hears_trial_end(); });
}

// The wall clock is cheap to read and runs ahead: a thread that had to wait for a processor has not had its turn.
bool PlanningTask::hears_trial_end() {
  if (!trial_->is_over && Clock::now() >= trial_->end) trial_->is_over = work_of_this_thread() >= trial_->end_of_work;
  return trial_->is_over;
}

Answer PlanningTask::search() {
  if (caller_.has_left()) return gone("before the search");
  return answer(steps_->search(caller_.budget(budget_left_)));
}

Answer PlanningTask::answer(const Outcome& outcome) {
  if (caller_.has_left()) return gone("while it ran");
  response_ = response_message(outcome);
  return {grpc::Status::OK, logs_details() ? note_on(response_) : ""};
}

void PlanningTask::finish(Answer answer) {
  steps_.reset();  // what it knows is large, and the answer may have to wait for a slow reader
  answer.waited = waited_;
  done_(answer);
}

}  // namespace dualarm
