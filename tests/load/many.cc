#include "tests/load/many.h"

#include <fmt/format.h>

#include <atomic>
#include <set>
#include <thread>
#include <vector>

#include "tests/load/figures.h"
#include "tests/load/requests.h"
#include "tests/load/server_child.h"

namespace dualarm {
namespace {

using BatchStream = grpc::ClientReaderWriter<wire::PlanMotionBatchRequest, wire::PlanMotionBatchResponse>;

wire::PlanMotionBatchRequest batch_request(int number, const wire::PlanMotionRequest& request) {
  wire::PlanMotionBatchRequest numbered;
  numbered.set_request_id(std::to_string(number));
  *numbered.mutable_request() = request;
  return numbered;
}

double seconds_since(LoadClock::time_point begin) {
  return std::chrono::duration<double>(LoadClock::now() - begin).count();
}

int stream_at_once(const ServerChild& server, int count) {
  const auto stub = wire::PlanningService::NewStub(new_channel(server.address()));
  wire::PlanMotionStreamRequest request;
  *request.mutable_request() = scenario_request("paper_case1");
  std::vector<std::unique_ptr<grpc::ClientContext>> contexts;
  std::vector<std::unique_ptr<grpc::ClientReader<wire::PlanMotionStreamResponse>>> streams;
  const auto begin = LoadClock::now();
  for (int i = 0; i < count; ++i) {
    contexts.push_back(std::make_unique<grpc::ClientContext>());
    streams.push_back(stub->PlanMotionStream(contexts.back().get(), request));
  }
  int planned = 0;
  for (const auto& stream : streams) {
    wire::PlanMotionStreamResponse event;
    int outcomes = 0;
    while (stream->Read(&event)) outcomes += event.has_outcome() && event.outcome().has_plan() ? 1 : 0;
    planned += stream->Finish().ok() && outcomes == 1 ? 1 : 0;
  }
  fmt::print("{} of {} streams ended with one plan, in {:.2f} s\n", planned, count, seconds_since(begin));
  return planned;
}

int batches_at_once(const ServerChild& server, int count) {
  constexpr int kEach = 3;
  const auto stub = wire::PlanningService::NewStub(new_channel(server.address()));
  const wire::PlanMotionRequest request = scenario_request("paper_case1");
  std::vector<std::unique_ptr<grpc::ClientContext>> contexts;
  std::vector<std::unique_ptr<BatchStream>> streams;
  const auto begin = LoadClock::now();
  for (int i = 0; i < count; ++i) {
    contexts.push_back(std::make_unique<grpc::ClientContext>());
    streams.push_back(stub->PlanMotionBatch(contexts.back().get()));
    for (int j = 0; j < kEach; ++j) streams.back()->Write(batch_request(j, request));
  }
  int planned = 0;
  for (const auto& stream : streams) {
    stream->WritesDone();
    wire::PlanMotionBatchResponse answer;
    int answers = 0;
    while (stream->Read(&answer)) answers += answer.response().has_plan() ? 1 : 0;
    planned += stream->Finish().ok() && answers == kEach ? 1 : 0;
  }
  fmt::print("{} of {} batches of {} requests were answered in full, in {:.2f} s\n", planned, count, kEach,
             seconds_since(begin));
  return planned;
}

}  // namespace

int open_many_streams(int count) {
  const ServerChild server(default_options());
  const int streams = stream_at_once(server, count);
  const int batches = batches_at_once(server, count);
  fmt::print("server: {:.0f} MiB\n", resident_mebibytes(server.pid()));
  return streams == count && batches == count ? 0 : 1;
}

int plan_one_batch(int count) {
  const ServerChild server(default_options());
  const auto stub = wire::PlanningService::NewStub(new_channel(server.address()));
  const wire::PlanMotionRequest good = scenario_request("paper_case1");
  wire::PlanMotionRequest bad = good;
  bad.clear_tasks();
  grpc::ClientContext context;
  const auto stream = stub->PlanMotionBatch(&context);
  const auto begin = LoadClock::now();
  std::jthread writer([&] {
    for (int i = 0; i < count; ++i) stream->Write(batch_request(i, i % 100 == 99 ? bad : good));
    stream->WritesDone();
  });
  std::set<int> planned;
  std::set<int> refused;
  double early = 0.0;
  wire::PlanMotionBatchResponse answer;
  while (stream->Read(&answer)) {
    (answer.has_error() ? refused : planned).insert(std::stoi(answer.request_id()));
    if (static_cast<int>(planned.size()) == count / 10) early = resident_mebibytes(server.pid());
  }
  const bool ended = stream->Finish().ok();
  const double seconds = seconds_since(begin);
  fmt::print(
      "{} planned, {} refused of {} requests in {:.1f} s, {:.0f}/s; server: {:.0f} MiB after a tenth, {:.0f} MiB "
      "at the end\n",
      planned.size(), refused.size(), count, seconds, count / seconds, early, resident_mebibytes(server.pid()));
  const bool complete =
      static_cast<int>(refused.size()) == count / 100 && static_cast<int>(planned.size() + refused.size()) == count;
  return ended && complete ? 0 : 1;
}

int refuse_to_read(double seconds) {
  const ServerChild server(default_options());
  const auto stub = wire::PlanningService::NewStub(new_channel(server.address()));
  const wire::PlanMotionRequest request = scenario_request("paper_case1");
  grpc::ClientContext context;
  const auto stream = stub->PlanMotionBatch(&context);
  std::atomic<int> sent = 0;
  std::jthread writer([&] {
    while (stream->Write(batch_request(sent, request))) ++sent;
  });
  std::this_thread::sleep_for(std::chrono::duration<double>(0.1 * seconds));
  const double early = resident_mebibytes(server.pid());
  const int sent_early = sent;
  std::this_thread::sleep_for(std::chrono::duration<double>(0.9 * seconds));
  const double late = resident_mebibytes(server.pid());
  fmt::print(
      "a client that does not read: {} requests and {:.1f} MiB after {:.1f} s, {} requests and {:.1f} MiB after "
      "{:.0f} s\n",
      sent_early, early, 0.1 * seconds, sent.load(), late, seconds);
  context.TryCancel();
  return late < early + 5.0 ? 0 : 1;
}

}  // namespace dualarm
