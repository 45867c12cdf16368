#include "tests/load/overload.h"

#include <fmt/format.h>

#include <atomic>
#include <stop_token>
#include <thread>
#include <vector>

#include "tests/load/figures.h"
#include "tests/load/requests.h"
#include "tests/load/server_child.h"

namespace dualarm {
namespace {

struct Sample {
  Latencies plans;
  Latencies health;
  int failures = 0;
};

Sample sample(const std::string& address, double seconds) {
  const auto channel = new_channel(address);
  const auto stub = wire::PlanningService::NewStub(channel);
  const wire::PlanMotionRequest request = scenario_request("paper_case1");
  Sample result;
  const auto end = LoadClock::now() + std::chrono::duration<double>(seconds);
  while (LoadClock::now() < end) {
    auto begin = LoadClock::now();
    grpc::ClientContext context;
    wire::PlanMotionResponse response;
    const bool planned = stub->PlanMotion(&context, request, &response).ok() && response.has_plan();
    result.plans.add(LoadClock::now() - begin);
    begin = LoadClock::now();
    result.failures += planned && is_healthy(channel) ? 0 : 1;
    result.health.add(LoadClock::now() - begin);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return result;
}

/// Searches one after another until told to stop; one that is refused is tried again after a while.
void keep_searching(const std::string& address, int seed, const std::stop_token& stop, std::atomic<int>& done) {
  const auto stub = wire::PlanningService::NewStub(new_channel(address));
  const wire::PlanMotionRequest request = search_request("paper_retreat", seed);
  while (!stop.stop_requested()) {
    grpc::ClientContext context;
    const std::stop_callback cancel(stop, [&context] { context.TryCancel(); });
    wire::PlanMotionResponse response;
    const grpc::Status status = stub->PlanMotion(&context, request, &response);
    if (status.ok()) ++done;
    if (status.error_code() == grpc::StatusCode::RESOURCE_EXHAUSTED) {
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
    }
  }
}

}  // namespace

int measure_overload(double seconds, int searches) {
  const ServerChild server(default_options());
  sample(server.address(), 0.5);  // warms up
  const Sample alone = sample(server.address(), seconds);
  std::atomic<int> done = 0;
  std::vector<std::jthread> threads;
  for (int i = 0; i < searches; ++i) {
    threads.emplace_back([&, i](const std::stop_token& stop) { keep_searching(server.address(), i, stop, done); });
  }
  std::this_thread::sleep_for(std::chrono::seconds(1));  // until all of them are queued
  const int before = done;
  const Sample loaded = sample(server.address(), seconds);
  const int meanwhile = done - before;
  const Sample again = sample(server.address(), seconds);
  for (std::jthread& thread : threads) thread.request_stop();
  threads.clear();
  fmt::print("fast plans   alone: {}\n", alone.plans.summary());
  fmt::print("             under {} searches: {}; ratio of p99 {:.2f}\n", searches, loaded.plans.summary(),
             loaded.plans.quantile(0.99) / alone.plans.quantile(0.99));
  fmt::print("             and again: {}\n", again.plans.summary());
  fmt::print("health       alone: {}\n", alone.health.summary());
  fmt::print("             under {} searches: {}\n", searches, loaded.health.summary());
  fmt::print("searches done meanwhile: {}; failures: {}\n", meanwhile, alone.failures + loaded.failures);
  return alone.failures + loaded.failures == 0 ? 0 : 1;
}

}  // namespace dualarm
