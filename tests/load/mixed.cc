#include "tests/load/mixed.h"

#include <fmt/format.h>

#include <atomic>
#include <functional>
#include <map>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "tests/load/figures.h"
#include "tests/load/requests.h"
#include "tests/load/server_child.h"
#include "tests/server/http_get.h"

namespace dualarm {
namespace {

using Stub = wire::PlanningService::Stub;
using Code = grpc::StatusCode;

const char* const kScenarios[] = {"paper_case1", "paper_case2",  "paper_object",
                                  "wipers",      "tower_cranes", "moving_start"};

/// Counts by name, from any thread.
class Tally {
 public:
  void add(const std::string& what) {
    const std::lock_guard lock(mutex_);
    ++counts_[what];
  }
  long of(const std::string& prefix) const {
    const std::lock_guard lock(mutex_);
    long sum = 0;
    for (const auto& [what, count] : counts_) sum += what.starts_with(prefix) ? count : 0;
    return sum;
  }
  void print() const {
    const std::lock_guard lock(mutex_);
    for (const auto& [what, count] : counts_) fmt::print("  {:>9}  {}\n", count, what);
  }

 private:
  mutable std::mutex mutex_;
  std::map<std::string, long> counts_;
};

/// What every kind of load gets.
struct Load {
  std::string address;
  Tally& tally;
  const std::atomic<bool>& stops;

  /// What is answered as it should be, or LOST.
  void note(const std::string& kind, const grpc::Status& status, bool is_answered, Code also_fine = Code::OK) const {
    if (status.ok() && is_answered) {
      tally.add(kind + ": answered");
    } else if (status.error_code() == also_fine && !status.ok()) {
      tally.add(kind + ": " + (also_fine == Code::CANCELLED ? "cancelled" : "refused"));
    } else if (status.error_code() == Code::RESOURCE_EXHAUSTED) {
      tally.add(kind + ": overloaded");
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
    } else {
      tally.add("LOST " + kind + ": " + std::to_string(status.error_code()) + " " + status.error_message());
    }
  }
};

wire::PlanMotionRequest any_request(std::mt19937& random) {
  return scenario_request(kScenarios[random() % std::size(kScenarios)]);
}

void plan(const Load& load, Stub& stub, std::mt19937& random) {
  grpc::ClientContext context;
  wire::PlanMotionResponse response;
  const auto status = stub.PlanMotion(&context, any_request(random), &response);
  load.note("plan", status, response.has_plan());
}

void search(const Load& load, Stub& stub, std::mt19937& random) {
  grpc::ClientContext context;
  wire::PlanMotionResponse response;
  auto request = search_request("paper_retreat", static_cast<int>(random() % 100));
  request.mutable_options()->mutable_planning_budget()->set_seconds(1);
  const auto status = stub.PlanMotion(&context, request, &response);
  load.note("search", status, response.outcome_case() != wire::PlanMotionResponse::OUTCOME_NOT_SET);
}

void refuse(const Load& load, Stub& stub, std::mt19937& random) {
  grpc::ClientContext context;
  wire::PlanMotionResponse response;
  auto request = any_request(random);
  request.mutable_robot()->mutable_arms(0)->mutable_link()->set_length_m(-1.0);
  load.note("bad request", stub.PlanMotion(&context, request, &response), false, Code::INVALID_ARGUMENT);
}

/// A call that is cancelled after up to 20 ms; it may have ended before.
std::jthread cancel_soon(grpc::ClientContext& context, std::mt19937& random) {
  return std::jthread([&context, wait = std::chrono::microseconds(random() % 20'000)] {
    std::this_thread::sleep_for(wait);
    context.TryCancel();
  });
}

void stream(const Load& load, Stub& stub, std::mt19937& random) {
  const bool is_cancelled = random() % 3 == 0;
  wire::PlanMotionStreamRequest request;
  *request.mutable_request() = random() % 4 == 0 ? search_request("paper_retreat", 1) : any_request(random);
  request.mutable_request()->mutable_options()->mutable_planning_budget()->set_seconds(1);
  grpc::ClientContext context;
  std::jthread canceller;
  const auto reader = stub.PlanMotionStream(&context, request);
  if (is_cancelled) canceller = cancel_soon(context, random);
  int outcomes = 0;
  for (wire::PlanMotionStreamResponse event; reader->Read(&event);) outcomes += event.has_outcome() ? 1 : 0;
  const auto status = reader->Finish();
  load.note("stream", status, outcomes == 1, is_cancelled ? Code::CANCELLED : Code::OK);
}

void cancel(const Load& load, Stub& stub, std::mt19937& random) {
  grpc::ClientContext context;
  wire::PlanMotionResponse response;
  const auto canceller = cancel_soon(context, random);
  const auto status = stub.PlanMotion(&context, search_request("paper_retreat", 2), &response);
  load.note("cancelled plan", status, true, Code::CANCELLED);
}

/// Some requests, a bad one among them; one batch in four is broken off.
void batch(const Load& load, Stub& stub, std::mt19937& random) {
  const int count = static_cast<int>(random() % 200);
  const bool is_broken_off = random() % 4 == 0;
  const auto request = any_request(random);
  grpc::ClientContext context;
  const auto call = stub.PlanMotionBatch(&context);
  std::jthread writer([&] {
    for (int i = 0; i < count; ++i) {
      wire::PlanMotionBatchRequest numbered;
      numbered.set_request_id(std::to_string(i));
      if (i % 50 != 7) *numbered.mutable_request() = request;
      call->Write(numbered);
    }
    call->WritesDone();
  });
  int answers = 0;
  for (wire::PlanMotionBatchResponse answer; call->Read(&answer);) {
    if (++answers == count / 2 && is_broken_off) context.TryCancel();
  }
  writer.join();
  load.note("batch", call->Finish(), answers == count, is_broken_off ? Code::CANCELLED : Code::OK);
}

/// A connection of its own that goes while a batch and a search are under way.
void disconnect(const Load& load, Stub&, std::mt19937& random) {
  const auto own = wire::PlanningService::NewStub(new_channel(load.address));
  grpc::ClientContext context;
  const auto call = own->PlanMotionBatch(&context);
  wire::PlanMotionBatchRequest request;
  for (int i = 0; i < 20; ++i) {
    request.set_request_id(std::to_string(i));
    *request.mutable_request() = i % 5 == 0 ? search_request("paper_retreat", i) : any_request(random);
    if (!call->Write(request)) break;
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(random() % 50));
  context.TryCancel();
  load.tally.add("connection: gone");
}

/// Writes to a batch and reads nothing, until it is stopped.
void never_read(const Load& load) {
  const auto stub = wire::PlanningService::NewStub(new_channel(load.address));
  grpc::ClientContext context;
  const auto call = stub->PlanMotionBatch(&context);
  std::jthread stopper([&] {
    while (!load.stops) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    context.TryCancel();
  });
  wire::PlanMotionBatchRequest request;
  *request.mutable_request() = scenario_request("paper_case1");
  for (int i = 0; call->Write(request); ++i) request.set_request_id(std::to_string(i));
}

using Kind = std::function<void(const Load&, Stub&, std::mt19937&)>;

void repeat(const Load& load, const Kind& kind, unsigned seed) {
  std::mt19937 random(seed);
  const auto stub = wire::PlanningService::NewStub(new_channel(load.address));
  while (!load.stops) kind(load, *stub, random);
}

/// A gauge of the server's metrics, by its name with labels, in MiB.
double metric_mebibytes(const ServerChild& server, const std::string& name) {
  const std::string text = http_get(server.metrics_address(), "/metrics");
  const std::size_t found = text.find("\n" + name + " ");
  return found == std::string::npos ? 0.0 : std::stod(text.substr(found + name.size() + 2)) / (1024.0 * 1024.0);
}

/// Mean of a part of the samples.
double mean(const std::vector<double>& samples, double from, double to) {
  const auto size = static_cast<double>(samples.size());
  const auto begin = samples.begin() + static_cast<std::ptrdiff_t>(from * size);
  const auto end = samples.begin() + static_cast<std::ptrdiff_t>(to * size);
  double sum = 0.0;
  for (auto sample = begin; sample != end; ++sample) sum += *sample;
  return begin == end ? 0.0 : sum / static_cast<double>(end - begin);
}

}  // namespace

int run_mixed_load(double seconds, unsigned seed) {
  const ServerChild server(default_options());
  Tally tally;
  std::atomic<bool> stops = false;
  const Load load{server.address(), tally, stops};
  std::vector<double> memory;
  std::vector<double> used;
  {
    std::vector<std::jthread> threads;
    for (const Kind& kind : {Kind(plan), Kind(plan), Kind(search), Kind(refuse), Kind(stream), Kind(stream),
                             Kind(cancel), Kind(batch), Kind(batch), Kind(disconnect)}) {
      threads.emplace_back([&load, kind, own = ++seed] { repeat(load, kind, own); });
    }
    threads.emplace_back([&load] { never_read(load); });
    constexpr int kSamples = 600;
    for (int i = 0; i < kSamples; ++i) {
      std::this_thread::sleep_for(std::chrono::duration<double>(seconds / kSamples));
      memory.push_back(resident_mebibytes(server.pid()));
      used.push_back(metric_mebibytes(server, "process_heap_bytes{state=\"used\"}"));
    }
    stops = true;
  }
  const bool lives = server.is_alive() && is_healthy(new_channel(server.address()));
  const double third = mean(memory, 0.2, 0.3);
  const double last = mean(memory, 0.9, 1.0);
  fmt::print("{:.0f} s of mixed load: the server {}\n", seconds, lives ? "lives" : "IS GONE");
  tally.print();
  fmt::print("memory by tenths, MiB:");
  for (int tenth = 0; tenth < 10; ++tenth) fmt::print(" {:.1f}", mean(memory, 0.1 * tenth, 0.1 * (tenth + 1)));
  fmt::print("; the last against the third {:+.1f} %\n", 100.0 * (last / third - 1.0));
  fmt::print("of it in use by the heap:");
  for (int tenth = 0; tenth < 10; ++tenth) fmt::print(" {:.1f}", mean(used, 0.1 * tenth, 0.1 * (tenth + 1)));
  fmt::print("\n");
  return lives && tally.of("LOST") == 0 && last < 1.05 * third ? 0 : 1;
}

}  // namespace dualarm
