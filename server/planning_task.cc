#include "server/planning_task.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "server/errors.h"
#include "server/response/responses.h"

namespace dualarm {
namespace {

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
  if (!submit(planner_.pools.quick, &PlanningTask::begin, Queue::kYes)) finish({overloaded(), "queue full"});
}

bool PlanningTask::submit(WorkerPool& pool, void (PlanningTask::*step)(), Queue queue) {
  submitted_ = Clock::now();
  WorkerPool::Task task = [this, step] {
    waited_ += Clock::now() - submitted_;
    (this->*step)();
  };
  if (when_full_ == WhenFull::kRefuse) {
    return queue == Queue::kYes ? pool.try_submit(std::move(task)) : pool.try_submit_at_once(std::move(task));
  }
  pool.submit(std::move(task));
  return true;
}

// Where the search is to come, it may have come and gone when plan_quickly() returns: nothing of this is touched then.
void PlanningTask::begin() {
  auto answer = answer_of(caller_.rpc(), request_, [this] { return plan_quickly(); });
  if (answer) finish(*std::move(answer));
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
  steps_ = planner_.functions.begin_planning(wish_.problem, caller_.budget(allowed), observer_);
  if (const auto outcome = steps_->quick()) return answer(*outcome);
  if (caller_.has_left()) return gone("before the search");
  budget_left_ = allowed - (Clock::now() - begin);
  const auto outcome = steps_->in_hand();
  if (submit(planner_.pools.search, &PlanningTask::resume, outcome ? Queue::kNo : Queue::kYes)) return std::nullopt;
  if (outcome) return answer(*outcome);
  return Answer{searches_overloaded(), "search queue full"};
}

Answer PlanningTask::search() {
  if (caller_.has_left()) return gone("before the search");
  return answer(steps_->search(caller_.budget(budget_left_)));
}

Answer PlanningTask::answer(const Outcome& outcome) {
  if (caller_.has_left()) return gone("while it ran");
  response_ = response_message(outcome);
  return {grpc::Status::OK, note_on(response_)};
}

void PlanningTask::finish(Answer answer) {
  steps_.reset();  // what it knows is large, and the answer may have to wait for a slow reader
  answer.waited = waited_;
  done_(answer);
}

}  // namespace dualarm
