#include "server/calls/stream_call.h"

#include <gmock/gmock.h>

#include <atomic>
#include <future>
#include <random>
#include <thread>

#include "tests/server/error_detail.h"
#include "tests/server/paper_request.h"
#include "tests/server/test_server.h"

namespace dualarm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Code = grpc::StatusCode;
using Event = wire::PlanMotionStreamResponse;

wire::PlanMotionStreamRequest stream_request() {
  wire::PlanMotionStreamRequest request;
  *request.mutable_request() = paper_request();
  return request;
}

/// One call, read to its end.
struct Heard {
  std::vector<Event> events;
  grpc::Status status;

  explicit Heard(const TestServer& server, const wire::PlanMotionStreamRequest& request = stream_request()) {
    grpc::ClientContext context;
    read(*server.stub()->PlanMotionStream(&context, request));
  }
  explicit Heard(grpc::ClientReader<Event>& reader) { read(reader); }

  std::vector<double> plans() const {
    std::vector<double> durations;
    for (const Event& event : events) {
      if (event.has_incumbent()) durations.push_back(event.incumbent().duration_s());
    }
    return durations;
  }
  std::vector<wire::Progress> progress() const {
    std::vector<wire::Progress> found;
    for (const Event& event : events) {
      if (event.has_progress()) found.push_back(event.progress());
    }
    return found;
  }
  long outcomes() const {
    return std::count_if(events.begin(), events.end(), [](const Event& event) { return event.has_outcome(); });
  }

 private:
  void read(grpc::ClientReader<Event>& reader) {
    for (Event event; reader.Read(&event);) events.push_back(event);
    status = reader.Finish();
  }
};

TEST(StreamCall, SendsEachBetterPlanAndThenTheOutcome) {
  const TestServer server(functions_with(search_planning([](const auto&, const auto&, const Observer& observer) {
    for (const double duration : {3.0, 2.5, 2.0}) observer.on_incumbent(plan_of(duration));
    return Outcome{plan_of(2.0), {}};
  })));
  const Heard heard(server);
  ASSERT_TRUE(heard.status.ok()) << heard.status.error_message();
  EXPECT_THAT(heard.plans(), ElementsAre(3.0, 2.5, 2.0));
  EXPECT_EQ(heard.outcomes(), 1);
  ASSERT_TRUE(heard.events.back().has_outcome());
  EXPECT_EQ(heard.events.back().outcome().plan().duration_s(), 2.0);
}

TEST(StreamCall, SendsAPlanWhilePlanningGoesOn) {
  std::promise<void> read;
  const TestServer server(functions_with(quick_planning([&read](const auto&, const auto&, const Observer& observer) {
                            observer.on_incumbent(plan_of(3.0));
                            EXPECT_EQ(read.get_future().wait_for(std::chrono::seconds(30)), std::future_status::ready);
                            return Outcome{plan_of(2.0), {}};
                          })),
                          patient_options());
  grpc::ClientContext context;
  const auto reader = server.stub()->PlanMotionStream(&context, stream_request());
  Event event;
  ASSERT_TRUE(reader->Read(&event));
  EXPECT_EQ(event.incumbent().duration_s(), 3.0);
  read.set_value();
  EXPECT_EQ(Heard(*reader).outcomes(), 1);
}

TEST(StreamCall, TellsProgressAtMostEveryTenthOfASecond) {
  const TestServer server(
      functions_with(quick_planning([](const auto&, const Budget& budget, const Observer& observer) {
        observer.on_incumbent(plan_of(3.0));
        for (int i = 1; !budget.exhausted(); ++i) observer.on_status({"search", 1.5, i});
        return Outcome{plan_of(2.0), {}};
      })));
  wire::PlanMotionStreamRequest request = stream_request();
  request.mutable_request()->mutable_options()->mutable_planning_budget()->set_nanos(800'000'000);
  const Heard heard(server, request);
  ASSERT_TRUE(heard.status.ok());
  const auto progress = heard.progress();
  ASSERT_GE(progress.size(), 2u);
  EXPECT_LE(progress.size(), 8u);
  EXPECT_EQ(progress[0].phase(), "search");
  EXPECT_EQ(progress[0].lower_bound_s(), 1.5);
  EXPECT_EQ(progress[0].best_duration_s(), 3.0);
  for (std::size_t i = 1; i < progress.size(); ++i) {
    EXPECT_GE(progress[i].elapsed_s() - progress[i - 1].elapsed_s(), 0.1);
    EXPECT_GT(progress[i].fallback_evaluation_count(), progress[i - 1].fallback_evaluation_count());
  }
}

TEST(StreamCall, TellsProgressOnceASecondEvenOfSilentPlanningAndOfWaiting) {
  EXPECT_LT(ProgressPace::kLongest, std::chrono::seconds(1));
  ServerOptions options = patient_options();
  options.search_threads = 1;
  const TestServer server(functions_with(search_planning([](const auto&, const Budget& budget, const auto&) {
                            while (!budget.exhausted()) std::this_thread::yield();
                            return undecided("");
                          })),
                          options);
  wire::PlanMotionStreamRequest request = stream_request();
  request.mutable_request()->mutable_options()->mutable_planning_budget()->set_nanos(700'000'000);
  auto first = std::async(std::launch::async, [&] { return Heard(server, request); });
  const Heard second(server, request);
  EXPECT_FALSE(first.get().progress().empty());
  const auto progress = second.progress();
  ASSERT_FALSE(progress.empty());
  EXPECT_EQ(progress[0].phase(), "waiting for a worker");
  EXPECT_FALSE(progress[0].has_best_duration_s());
  double last = 0.0;
  for (const wire::Progress& told : progress) {
    EXPECT_LT(told.elapsed_s() - last, 1.0);
    last = told.elapsed_s();
  }
}

TEST(StreamCall, ADeadlineCutsOffNothingThatWasFound) {
  const TestServer server(
      functions_with(search_planning([](const auto&, const Budget& budget, const Observer& observer) {
        observer.on_incumbent(plan_of(3.0));
        while (!budget.exhausted()) std::this_thread::yield();
        return Outcome{plan_of(3.0), {}};
      })),
      patient_options());
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + std::chrono::milliseconds(500));
  const Heard heard(*server.stub()->PlanMotionStream(&context, stream_request()));
  EXPECT_THAT(heard.plans(), ElementsAre(3.0));
  // The outcome is sent 20 ms before the deadline; on a machine under load it may still come too late.
  EXPECT_EQ(heard.outcomes(), heard.status.ok() ? 1 : 0);
  EXPECT_TRUE(heard.status.ok() || heard.status.error_code() == Code::DEADLINE_EXCEEDED);
}

TEST(StreamCall, ACallerWhoCancelsStopsTheWorkAndGetsNoOutcome) {
  std::promise<bool> cancelled;
  const TestServer server(
      functions_with(search_planning([&](const auto&, const Budget& budget, const Observer& observer) {
        observer.on_incumbent(plan_of(3.0));
        while (!budget.exhausted()) std::this_thread::yield();
        cancelled.set_value(budget.cancelled());
        return Outcome{plan_of(3.0), {}};
      })),
      patient_options());
  grpc::ClientContext context;
  const auto reader = server.stub()->PlanMotionStream(&context, stream_request());
  Event event;
  ASSERT_TRUE(reader->Read(&event));
  context.TryCancel();
  EXPECT_TRUE(cancelled.get_future().get());
  const Heard rest(*reader);
  EXPECT_EQ(rest.outcomes(), 0);
  EXPECT_EQ(rest.status.error_code(), Code::CANCELLED);
}

TEST(StreamCall, WhateverTheMomentOfTheCancelThereIsOneOutcomeOrNone) {
  const TestServer server(functions_with(search_planning([](const auto&, const auto&, const Observer& observer) {
    for (const double duration : {3.0, 2.5}) observer.on_incumbent(plan_of(duration));
    return Outcome{plan_of(2.0), {}};
  })));
  const auto stub = server.stub();
  std::mt19937 random(7);
  int finished = 0;
  for (int i = 0; i < 300; ++i) {
    grpc::ClientContext context;
    const auto reader = stub->PlanMotionStream(&context, stream_request());
    std::thread canceller([&context, i, wait = std::chrono::microseconds(1 << random() % 15)] {
      if (i % 10 == 0) return;
      std::this_thread::sleep_for(wait);
      context.TryCancel();
    });
    const Heard heard(*reader);
    canceller.join();
    EXPECT_LE(heard.outcomes(), 1);
    if (heard.status.ok()) {
      ++finished;
      EXPECT_EQ(heard.outcomes(), 1);
      EXPECT_TRUE(heard.events.back().has_outcome());
    }
  }
  EXPECT_GE(finished, 30);
  EXPECT_LT(finished, 300);
}

TEST(StreamCall, ReportsWhatIsWrongAsPlanMotionDoes) {
  std::atomic<int> calls = 0;
  const TestServer server(functions_with(quick_planning([&calls](const auto&...) -> Outcome {
    ++calls;
    throw std::logic_error("secret of the house");
  })));
  wire::PlanMotionStreamRequest request = stream_request();
  request.mutable_request()->clear_tasks();
  const Heard malformed(server, request);
  EXPECT_TRUE(malformed.events.empty());
  EXPECT_EQ(malformed.status.error_code(), Code::INVALID_ARGUMENT);
  EXPECT_EQ(detail_of<google::rpc::BadRequest>(malformed.status).field_violations(0).field(), "tasks");
  EXPECT_EQ(Heard(server, {}).status.error_code(), Code::INVALID_ARGUMENT);
  EXPECT_EQ(calls, 0);

  const Heard bug(server);
  EXPECT_EQ(bug.status.error_code(), Code::INTERNAL);
  EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(bug.status).reason(), "BUG");
  EXPECT_EQ(calls, 1);

  request = stream_request();
  request.mutable_request()->mutable_options()->set_validate_only(true);
  const Heard valid(server, request);
  EXPECT_TRUE(valid.status.ok());
  ASSERT_EQ(valid.events.size(), 1u);
  EXPECT_EQ(valid.events[0].outcome().outcome_case(), wire::PlanMotionResponse::OUTCOME_NOT_SET);
  EXPECT_EQ(calls, 1);
}

// 2 MB of knots each: far more than the network keeps.
Plan large_plan(double duration) {
  Plan plan = plan_of(duration);
  for (auto& trajectory : plan.trajectory) trajectory.knots.resize(25'000);
  return plan;
}

TEST(StreamCall, ASlowReaderMissesOldPlansAndCostsNoMemoryForThem) {
  constexpr int kPlans = 200;
  std::promise<void> found;
  std::shared_future<void> all_found = found.get_future().share();
  const TestServer server(functions_with(quick_planning([&found](const auto&, const auto&, const Observer& observer) {
                            for (int i = kPlans; i > 0; --i) observer.on_incumbent(large_plan(i));
                            found.set_value();
                            return Outcome{plan_of(1.0), {}};
                          })),
                          patient_options());
  grpc::ClientContext context;
  const auto reader = server.stub()->PlanMotionStream(&context, stream_request());
  all_found.wait();
  const Heard heard(*reader);
  ASSERT_TRUE(heard.status.ok()) << heard.status.error_message();
  const auto plans = heard.plans();
  EXPECT_LT(plans.size(), 40u);
  EXPECT_TRUE(std::is_sorted(plans.rbegin(), plans.rend()));
  EXPECT_EQ(plans.back(), 1.0);
  EXPECT_EQ(heard.outcomes(), 1);
}

TEST(StreamCall, MoreStreamsThanAllowedAreRefusedUntilOneEnds) {
  std::promise<void> begun;
  std::promise<void> release;
  ServerOptions options = patient_options();
  options.max_streams = 1;
  std::atomic<bool> has_begun = false;
  const TestServer server(functions_with(quick_planning([&](const auto&...) {
                            if (!has_begun.exchange(true)) {
                              begun.set_value();
                              release.get_future().wait();
                            }
                            return undecided("");
                          })),
                          options);
  auto first = std::async(std::launch::async, [&] { return Heard(server); });
  begun.get_future().wait();
  const Heard refused(server);
  EXPECT_EQ(refused.status.error_code(), Code::RESOURCE_EXHAUSTED);
  EXPECT_THAT(refused.status.error_message(), HasSubstr("as many streams are open as this server allows"));
  EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(refused.status).reason(), "TOO_MANY_STREAMS");
  EXPECT_EQ(detail_of<google::rpc::RetryInfo>(refused.status).retry_delay().seconds(), 1);
  release.set_value();
  EXPECT_TRUE(first.get().status.ok());
  // The place is free a moment after the caller has the outcome.
  while (!Heard(server).status.ok()) std::this_thread::yield();
}

}  // namespace
}  // namespace dualarm
