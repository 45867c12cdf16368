// What a server under load promises: quick work never waits behind slow work, and what does not fit is refused at once.
#include <gmock/gmock.h>

#include <atomic>
#include <future>
#include <latch>
#include <thread>

#include "tests/server/error_detail.h"
#include "tests/server/paper_request.h"
#include "tests/server/test_server.h"

namespace dualarm {
namespace {

using ::testing::HasSubstr;
using Code = grpc::StatusCode;

constexpr int kNeedsSearch = 1;  // as a seed

wire::PlanMotionRequest request_with_seed(int seed) {
  wire::PlanMotionRequest request = paper_request();
  request.mutable_options()->set_seed(seed);
  return request;
}

struct Call {
  grpc::ClientContext context;
  wire::PlanMotionResponse response;
  std::future<grpc::Status> status;

  Call(const TestServer& server, const wire::PlanMotionRequest& request)
      : status(std::async(std::launch::async, [this, stub = server.stub(), request] {
          return stub->PlanMotion(&context, request, &response);
        })) {}
};

grpc::Status plan_motion(const TestServer& server, const wire::PlanMotionRequest& request) {
  grpc::ClientContext context;
  wire::PlanMotionResponse response;
  return server.stub()->PlanMotion(&context, request, &response);
}

/// Plans with kNeedsSearch search until they are released or their budget is exhausted; others are quick.
class Searches {
 public:
  PlanningFunctions functions() {
    return functions_with([this](const Problem& problem, const Budget& budget, const Observer& observer) {
      const auto quick = quick_planning([](const auto&...) { return undecided("quick"); });
      const auto search = search_planning([this](const auto&, const Budget& given, const auto&) {
        ++running_;
        while (!is_released_ && !given.exhausted()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return undecided(given.exhausted() ? "budget spent" : "searched");
      });
      if (problem.options.seed != kNeedsSearch) return quick(problem, budget, observer);
      ++begun_;
      return search(problem, budget, observer);
    });
  }
  void wait_for(int running) const {
    while (running_ < running) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  /// The quick step of so many is done, or about to be.
  void wait_for_begun(int begun) const {
    while (begun_ < begun) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  void release() { is_released_ = true; }

 private:
  std::atomic<int> begun_ = 0;
  std::atomic<int> running_ = 0;
  std::atomic<bool> is_released_ = false;
};

/// Plans with kNeedsSearch take a thread's whole time by quick methods until they are released; others are quick.
class SlowPlans {
 public:
  PlanningFunctions functions() {
    return functions_with(quick_planning([this](const Problem& problem, const Budget& budget, const Observer&) {
      if (problem.options.seed != kNeedsSearch) return undecided("quick");
      ++begun_;
      while (!is_released_ && !budget.exhausted()) std::this_thread::yield();
      return undecided(budget.exhausted() ? "budget spent" : "slow");
    }));
  }
  void wait_for_begun(int begun) const {
    while (begun_ < begun) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  void release() { is_released_ = true; }

 private:
  std::atomic<int> begun_ = 0;
  std::atomic<bool> is_released_ = false;
};

ServerOptions one_search_at_a_time(int queue) {
  ServerOptions options = patient_options();
  options.worker_threads = 1;
  options.search_threads = 1;
  options.search_queue = queue;
  return options;
}

TEST(Overload, ASearchTooManyIsRefusedAtOnceWithARetryDelay) {
  Searches searches;
  const TestServer server(searches.functions(), one_search_at_a_time(0));
  Call running(server, request_with_seed(kNeedsSearch));
  searches.wait_for(1);
  const grpc::Status refused = plan_motion(server, request_with_seed(kNeedsSearch));
  EXPECT_EQ(refused.error_code(), Code::RESOURCE_EXHAUSTED);
  EXPECT_THAT(refused.error_message(), HasSubstr("the problem needs a search"));
  EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(refused).reason(), "SEARCH_QUEUE_FULL");
  EXPECT_EQ(detail_of<google::rpc::RetryInfo>(refused).retry_delay().seconds(), 1);
  searches.release();
  ASSERT_TRUE(running.status.get().ok());
  EXPECT_EQ(running.response.undecided().explanation(), "searched");
}

TEST(Overload, AShortPlanDoesNotWaitForSlowOnes) {
  SlowPlans plans;
  ServerOptions options = patient_options();
  options.worker_threads = 1;
  const TestServer server(plans.functions(), options);
  std::vector<std::unique_ptr<Call>> slow;
  for (int i = 0; i < 8; ++i) slow.push_back(std::make_unique<Call>(server, request_with_seed(kNeedsSearch)));
  plans.wait_for_begun(8);
  // Without an end of the slow ones in sight.
  EXPECT_TRUE(plan_motion(server, request_with_seed(0)).ok());
  for (const auto& call : slow) EXPECT_EQ(call->status.wait_for(std::chrono::seconds(0)), std::future_status::timeout);
  plans.release();
  for (const auto& call : slow) {
    ASSERT_TRUE(call->status.get().ok());
    EXPECT_EQ(call->response.undecided().explanation(), "slow");
  }
}

/// A plan of 2 s is in hand at once; searches find one of 1 s, the first of them only when it is released.
class PlansInHand {
 public:
  PlanningFunctions functions() {
    return functions_with(search_planning(
        [this](const auto&...) {
          if (!has_begun_.exchange(true)) {
            searching_.count_down();
            release_.get_future().wait();
          }
          return Outcome{plan_of(1.0), {}};
        },
        Outcome{plan_of(2.0), {}}));
  }
  void wait_for_search() { searching_.wait(); }
  void release() { release_.set_value(); }

 private:
  std::atomic<bool> has_begun_ = false;
  std::latch searching_{1};
  std::promise<void> release_;
};

TEST(Overload, PlansInHandWaitForTheirSearchesSoThatTheAnswersAreAlike) {
  PlansInHand plans;
  const TestServer server(plans.functions(), one_search_at_a_time(20));
  Call running(server, request_with_seed(0));
  plans.wait_for_search();
  std::vector<std::unique_ptr<Call>> calls;
  for (int i = 0; i < 16; ++i) calls.push_back(std::make_unique<Call>(server, request_with_seed(0)));
  EXPECT_EQ(calls.back()->status.wait_for(std::chrono::milliseconds(200)), std::future_status::timeout);
  plans.release();
  ASSERT_TRUE(running.status.get().ok());
  for (const auto& call : calls) {
    ASSERT_TRUE(call->status.get().ok());
    EXPECT_EQ(call->response.plan().duration_s(), 1.0);
  }
}

TEST(Overload, APlanInHandIsTheAnswerWhereNoSearchMayWait) {
  PlansInHand plans;
  const TestServer server(plans.functions(), one_search_at_a_time(0));
  Call running(server, request_with_seed(0));
  plans.wait_for_search();
  Call beside(server, request_with_seed(0));
  ASSERT_TRUE(beside.status.get().ok());
  EXPECT_EQ(beside.response.plan().duration_s(), 2.0);
  plans.release();
  ASSERT_TRUE(running.status.get().ok());
  EXPECT_EQ(running.response.plan().duration_s(), 1.0);
}

TEST(Overload, APlanInHandIsTheAnswerBeforeItsBudgetEndsInTheQueue) {
  PlansInHand plans;
  ServerOptions options = one_search_at_a_time(5);
  options.planning_budget = 0.4;
  const TestServer server(plans.functions(), options);
  Call running(server, request_with_seed(0));
  plans.wait_for_search();
  const auto begin = std::chrono::steady_clock::now();
  std::vector<std::unique_ptr<Call>> calls;
  for (int i = 0; i < 5; ++i) calls.push_back(std::make_unique<Call>(server, request_with_seed(0)));
  for (const auto& call : calls) {
    ASSERT_TRUE(call->status.get().ok());
    EXPECT_EQ(call->response.plan().duration_s(), 2.0);
  }
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(150)) << "it has waited";
  plans.release();
  ASSERT_TRUE(running.status.get().ok());
}

TEST(Overload, SixtyFourSearchesKeepNeitherQuickPlansNorHealthNorDrawingsWaiting) {
  Searches searches;
  const TestServer server(searches.functions(), one_search_at_a_time(63));
  std::vector<std::unique_ptr<Call>> calls;
  for (int i = 0; i < 64; ++i) calls.push_back(std::make_unique<Call>(server, request_with_seed(kNeedsSearch)));
  searches.wait_for_begun(64);
  EXPECT_EQ(plan_motion(server, request_with_seed(kNeedsSearch)).error_code(), Code::RESOURCE_EXHAUSTED);
  EXPECT_TRUE(plan_motion(server, request_with_seed(0)).ok());
  EXPECT_EQ(health_of(server.channel(), ""), 1);
  wire::GetForbiddenRegionRequest region;
  *region.mutable_robot() = paper_request().robot();
  grpc::ClientContext context;
  wire::GetForbiddenRegionResponse contours;
  EXPECT_TRUE(server.stub()->GetForbiddenRegion(&context, region, &contours).ok());
  searches.release();
  for (const auto& call : calls) EXPECT_TRUE(call->status.get().ok());
}

TEST(Overload, WaitingForASearchTakesNothingFromTheBudget) {
  Searches searches;
  const TestServer server(searches.functions(), one_search_at_a_time(1));
  Call first(server, request_with_seed(kNeedsSearch));
  searches.wait_for(1);
  wire::PlanMotionRequest impatient = request_with_seed(kNeedsSearch);
  impatient.mutable_options()->mutable_planning_budget()->set_nanos(300'000'000);
  const auto begin = std::chrono::steady_clock::now();
  Call second(server, impatient);
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  first.context.TryCancel();
  ASSERT_TRUE(second.status.get().ok());
  EXPECT_EQ(second.response.undecided().explanation(), "budget spent");
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(690));
}

TEST(Overload, CallersWhoLeaveTheQueueAreNotPlannedFor) {
  std::atomic<int> planned = 0;
  Searches searches;
  PlanningFunctions functions = searches.functions();
  functions.begin_planning = [&planned, inner = functions.begin_planning](const auto&... all) {
    ++planned;
    return inner(all...);
  };
  ServerOptions options = patient_options();
  options.worker_threads = 1;
  std::promise<void> release;
  std::promise<void> begun;
  functions.verify = [&](const auto&...) {
    begun.set_value();
    release.get_future().wait();
    return Verification{};
  };
  const TestServer server(functions, options);
  auto verifying = std::async(std::launch::async, [&] {
    grpc::ClientContext context;
    wire::VerifyMotionResponse response;
    return server.stub()->VerifyMotion(&context, paper_verify_request(), &response);
  });
  begun.get_future().wait();
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + std::chrono::milliseconds(50));
  wire::PlanMotionResponse response;
  EXPECT_EQ(server.stub()->PlanMotion(&context, paper_request(), &response).error_code(), Code::DEADLINE_EXCEEDED);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));  // in which the server hears of it, too
  release.set_value();
  EXPECT_TRUE(verifying.get().ok());
  EXPECT_TRUE(plan_motion(server, paper_request()).ok());
  EXPECT_EQ(planned, 1);
}

}  // namespace
}  // namespace dualarm
