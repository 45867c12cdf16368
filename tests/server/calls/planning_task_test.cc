#include "server/calls/planning_task.h"

#include <gmock/gmock.h>

#include <atomic>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

#include "tests/server/paper_request.h"
#include "tests/server/test_server.h"

namespace dualarm {
namespace {

constexpr bool kTriesInline = true;

ServerOptions one_worker(double inline_milliseconds) {
  ServerOptions options = patient_options();
  options.worker_threads = 1;
  options.queue_capacity = 0;
  options.inline_milliseconds = inline_milliseconds;
  return options;
}

wire::PlanMotionResponse planned(const TestServer& server) {
  grpc::ClientContext context;
  wire::PlanMotionResponse response;
  const grpc::Status status = server.stub()->PlanMotion(&context, paper_request(), &response);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return response;
}

TEST(PlanningTask, IsAnsweredAtOnceWhileTheWorkersAreBusy) {
  std::promise<void> begun;
  std::promise<void> release;
  PlanningFunctions functions = quick_functions();
  functions.verify = [&](const auto&...) {
    begun.set_value();
    release.get_future().wait();
    return Verification();
  };
  const TestServer server(functions, one_worker(100.0), kTriesInline);
  std::future<grpc::Status> verified = std::async(std::launch::async, [&] {
    grpc::ClientContext context;
    wire::VerifyMotionResponse response;
    return server.stub()->VerifyMotion(&context, paper_verify_request(), &response);
  });
  begun.get_future().wait();
  EXPECT_EQ(planned(server).undecided().explanation(), "quick");
  release.set_value();
  EXPECT_TRUE(verified.get().ok());
}

TEST(PlanningTask, BeginsAnewOnAWorkerWhereATrialIsTooShort) {
  std::mutex mutex;
  std::vector<std::thread::id> threads;
  const TestServer server(functions_with(quick_planning([&](const Problem&, const Budget& budget, const Observer&) {
                            bool is_first = false;
                            {
                              const std::lock_guard lock(mutex);
                              is_first = threads.empty();
                              threads.push_back(std::this_thread::get_id());
                            }
                            while (is_first && !budget.exhausted()) std::this_thread::yield();
                            return undecided(budget.exhausted() ? "cut off" : "whole");
                          })),
                          one_worker(1.0), kTriesInline);
  EXPECT_EQ(planned(server).undecided().explanation(), "whole");
  const std::lock_guard lock(mutex);
  ASSERT_EQ(threads.size(), 2u);
  EXPECT_NE(threads[0], threads[1]);
}

TEST(PlanningTask, SearchesAfterATrialThatFoundNothing) {
  const TestServer server(functions_with(search_planning([](const Problem&, const Budget& budget, const Observer&) {
                            std::this_thread::sleep_for(std::chrono::milliseconds(20));
                            return undecided(budget.exhausted() ? "cut off" : "searched");
                          })),
                          one_worker(10.0), kTriesInline);
  EXPECT_EQ(planned(server).undecided().explanation(), "searched");
}

TEST(PlanningTask, OnlyOneIsTriedAtATimeSoThatHealthAnswers) {
  std::atomic<int> begun = 0;
  std::atomic<bool> released = false;
  ServerOptions options = one_worker(100.0);
  options.worker_threads = 8;
  const TestServer server(functions_with(quick_planning([&](const auto&...) {
                            ++begun;  // heeds no budget, as no planner should
                            while (!released) std::this_thread::sleep_for(std::chrono::milliseconds(1));
                            return undecided("");
                          })),
                          options, kTriesInline);
  std::vector<std::future<void>> calls;
  for (int i = 0; i < 4; ++i) calls.push_back(std::async(std::launch::async, [&] { planned(server); }));
  while (begun < 4) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(health_of(server.channel(), ""), 1);
  released = true;
}

TEST(PlanningTask, GivesTheSameAnswerWhereverItRuns) {
  const TestServer pooled(core_functions(), one_worker(0.0), kTriesInline);
  const TestServer inlined(core_functions(), one_worker(100.0), kTriesInline);
  wire::PlanMotionResponse first = planned(pooled);
  wire::PlanMotionResponse second = planned(inlined);
  first.clear_statistics();
  second.clear_statistics();
  ASSERT_TRUE(first.has_plan());
  EXPECT_EQ(first.SerializeAsString(), second.SerializeAsString());
}

}  // namespace
}  // namespace dualarm
