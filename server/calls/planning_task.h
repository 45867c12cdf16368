#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

#include "server/calls/answer.h"
#include "server/calls/caller.h"
#include "server/calls/places.h"
#include "server/calls/ticker.h"
#include "server/planning_functions.h"
#include "server/pools/worker_pools.h"
#include "server/request/requests.h"
#include "server/wire.h"

namespace dualarm {

/// What plans: shared by all calls, outlives them.
struct Planner {
  PlanningFunctions functions;
  WorkerPools& pools;
  std::chrono::nanoseconds longest;  ///< computation for one request
  std::size_t search_memory;         ///< bytes of one search
  RequestLimits limits;
  std::chrono::nanoseconds trial;  ///< of processor time, for which gRPC's thread may try a plan; zero: not at all
  Places& trials;                  ///< how many of them may at once
  Ticker& ticker;
};

/// Whether a request is refused or waits when the pools are full.
enum class WhenFull { kRefuse, kWait };

/// One request of PlanMotion on its way to the answer, the same for every kind of call: parsed and planned by the quick
/// methods on one pool; where these take long they begin anew on another, so that nobody's short plan waits for a long
/// one; what they leave to the search goes on to a third, with what is left of its budget. Waiting takes nothing from
/// the budget. The answer is the same wherever it is made: what a trial was kept from looking at, it does not answer.
class PlanningTask final : private Ticker::Listener {
 public:
  /// Called once, as the task's last deed, on a worker or on the thread that starts the task: it may delete the task.
  using Done = std::function<void(const Answer&)>;

  /// All outlive the task. Where the answer is OK, the response holds it.
  PlanningTask(const Planner& planner, const Caller& caller, const wire::PlanMotionRequest& request,
               wire::PlanMotionResponse& response, WhenFull when_full, Done done, Observer observer = {});

  /// Hands the request to the pools.
  void start();

  /// Tries it on this thread, which is gRPC's, and hands it to the pools, from its beginning, only where that is not
  /// enough time: waking a worker takes about as long as a plan.
  void start_here();

 private:
  using Clock = Caller::Clock;

  /// A plan in hand that waits for its search. A thread that is free for the search ends the wait, or the tick that
  /// finds patience exhausted: whichever is first to say so.
  struct Wait {
    Outcome in_hand;
    Budget patience;
    std::atomic<bool> is_over = false;
  };

  /// Hands it to the pool; false if the pool is full. The task may be gone when this returns true.
  bool submit(WorkerPool& pool, void (PlanningTask::*step)());
  void begin();
  void start_slowly();
  void begin_slowly();

  /// Plans by the quick methods in so much processor time, and goes on. False, and nothing is left of it, if that is
  /// not enough; else the task may be gone.
  bool go_on_within(std::chrono::nanoseconds work);
  void go_on(std::optional<Answer> quick);
  void wait_for_search(const Outcome& in_hand);
  void tick(Ticker::Clock::time_point now) override;

  /// Whoever has ended the wait says so here. How long it was.
  Clock::duration end_wait();
  void answer_in_hand();
  void resume();

  /// Nothing where the search is to come, or where a trial was too short.
  std::optional<Answer> plan_quickly();
  bool hears_trial_end();
  Budget quick_budget(std::chrono::nanoseconds at_most);
  Answer search();
  Answer answer(const Outcome& outcome);
  void finish(Answer answer);

  const Planner& planner_;
  const Caller& caller_;
  const wire::PlanMotionRequest& request_;
  wire::PlanMotionResponse& response_;
  const WhenFull when_full_;
  const Done done_;
  const Observer observer_;
  struct Trial {
    Clock::time_point end;
    std::chrono::nanoseconds end_of_work;  // processor time of the thread
    bool is_over = false;                  // a planner has heard so
  };
  std::optional<Trial> trial_;  // while it is tried
  PlanWish wish_;
  std::chrono::nanoseconds budget_left_{};
  std::unique_ptr<PlanningSteps> steps_;
  std::shared_ptr<Wait> wait_;
  Clock::time_point submitted_;
  Clock::duration waited_{};
};

}  // namespace dualarm
