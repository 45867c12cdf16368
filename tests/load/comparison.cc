#include "tests/load/comparison.h"

#include <fmt/format.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/server_builder.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <future>
#include <thread>
#include <vector>

#include "core/planner.h"
#include "server/calls/call_observer.h"
#include "server/calls/malformed_requests.h"
#include "server/logging/logs.h"
#include "server/planning_service.h"
#include "server/request/requests.h"
#include "server/response/responses.h"
#include "server/security/guarded_service.h"
#include "tests/load/figures.h"
#include "tests/load/requests.h"
#include "tests/load/server_child.h"

namespace dualarm {
namespace {

constexpr char kEmptyMethod[] = "/dualarm.load.Empty/Call";
constexpr char kPlanMethod[] = "/dualarm.planning.v1.PlanningService/PlanMotion";

std::chrono::nanoseconds milliseconds(double count) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double, std::milli>(count));
}

/// Takes any bytes and answers always the same, as soon as gRPC hands the call over.
class EmptyService final : public grpc::Service {
 public:
  explicit EmptyService(const std::string& reply) : slice_(reply), reply_(&slice_, 1) {
    AddMethod(new grpc::internal::RpcServiceMethod(kEmptyMethod, grpc::internal::RpcMethod::NORMAL_RPC, nullptr));
    MarkMethodRawCallback(
        0, new grpc::internal::CallbackUnaryHandler<grpc::ByteBuffer, grpc::ByteBuffer>(
               [this](grpc::CallbackServerContext* context, const grpc::ByteBuffer*, grpc::ByteBuffer* response) {
                 *response = reply_;
                 auto* reactor = context->DefaultReactor();
                 reactor->Finish(grpc::Status::OK);
                 return reactor;
               }));
  }

 private:
  grpc::Slice slice_;
  grpc::ByteBuffer reply_;
};

/// Both services behind one port, and before both what every call passes: names, admission, metrics, the log at level
/// info (which goes nowhere).
struct ComparedServer {
  ServerOptions options = default_options();
  const bool logs = (start_logs("info"), std::freopen("/dev/null", "w", stderr) != nullptr);
  CallLog log{false};
  Metrics metrics;
  Admission admission;
  WorkerPools pools{options};
  PlanningService planning{core_functions(),
                           pools,
                           {std::chrono::seconds(10), 32u << 20, options.max_streams, options.batch_in_flight,
                            options.request, milliseconds(options.inline_milliseconds)}};
  OpenCalls open_calls;
  GuardedService guarded{planning, admission, open_calls};
  EmptyService empty;
  int port = 0;
  std::unique_ptr<grpc::Server> server;

  explicit ComparedServer(const std::string& reply) : empty(reply) {
    grpc::ServerBuilder builder;
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port);
    builder.RegisterService(&guarded);
    builder.RegisterService(&empty);
    std::vector<std::unique_ptr<grpc::experimental::ServerInterceptorFactoryInterface>> interceptors;
    interceptors.push_back(explain_malformed_requests());
    interceptors.push_back(observe_calls({log, metrics, admission, open_calls}));
    builder.experimental().SetInterceptorCreators(std::move(interceptors));
    server = builder.BuildAndStart();
  }
};

class UnaryCaller {
 public:
  explicit UnaryCaller(const std::string& address) : stub_(new_channel(address)) {}

  /// True if it was answered.
  bool call(const char* method, const wire::PlanMotionRequest& request, wire::PlanMotionResponse& response) {
    grpc::ClientContext context;
    std::promise<grpc::Status> done;
    stub_.UnaryCall(&context, method, {}, &request, &response,
                    [&done](grpc::Status status) { done.set_value(std::move(status)); });
    return done.get_future().get().ok() && response.has_plan();
  }

 private:
  grpc::TemplatedGenericStub<wire::PlanMotionRequest, wire::PlanMotionResponse> stub_;
};

struct Throughput {
  double answers = 0.0;           // a second
  double server_seconds = 0.0;    // of processor time, an answer
  double client_seconds = 0.0;    // the same
  double planning_seconds = 0.0;  // an answer, by the clock
};

Throughput throughput(const ServerChild& server, const char* method, const wire::PlanMotionRequest& request,
                      double seconds, int callers) {
  std::atomic<long> answers = 0;
  std::atomic<double> planning = 0.0;
  const double server_before = processor_seconds(server.pid());
  const double client_before = processor_seconds(getpid());
  const auto begin = LoadClock::now();
  const auto end = begin + std::chrono::duration<double>(seconds);
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < callers; ++i) {
      threads.emplace_back([&] {
        UnaryCaller caller(server.address());
        wire::PlanMotionResponse response;
        while (LoadClock::now() < end) {
          if (!caller.call(method, request, response)) continue;
          ++answers;
          planning += response.statistics().planning_time_s();
        }
      });
    }
  }
  const auto count = std::max(1.0, static_cast<double>(answers));
  return {static_cast<double>(answers) / std::chrono::duration<double>(LoadClock::now() - begin).count(),
          (processor_seconds(server.pid()) - server_before) / count,
          (processor_seconds(getpid()) - client_before) / count, planning / count};
}

/// What the server will answer, as bytes; without gRPC, which may not begin before the server is forked.
std::string planned_reply(const wire::PlanMotionRequest& request) {
  const auto parsed = parse(request);
  return response_message(plan(std::get<PlanWish>(parsed).problem, Budget())).SerializeAsString();
}

struct RoundTrips {
  Latencies empty;
  Latencies planned;
  Latencies rest;  // of those: without planning itself, which the statistics of the answer tell
};

/// In turn, so that both meet the same machine.
RoundTrips round_trips(const std::string& address, const wire::PlanMotionRequest& request, double seconds) {
  UnaryCaller caller(address);
  RoundTrips trips;
  const auto end = LoadClock::now() + std::chrono::duration<double>(seconds);
  wire::PlanMotionResponse response;
  while (LoadClock::now() < end) {
    auto begin = LoadClock::now();
    if (caller.call(kEmptyMethod, request, response)) trips.empty.add(LoadClock::now() - begin);
    begin = LoadClock::now();
    if (!caller.call(kPlanMethod, request, response)) continue;
    const auto trip = LoadClock::now() - begin;
    trips.planned.add(trip);
    const std::chrono::duration<double> planning(response.statistics().planning_time_s());
    trips.rest.add(trip - std::chrono::duration_cast<LoadClock::duration>(planning));
  }
  return trips;
}

}  // namespace

int compare_with_empty_call(const std::string& scenario, double seconds, int callers) {
  const wire::PlanMotionRequest request = scenario_request(scenario);
  const std::string reply = planned_reply(request);
  const ServerChild server([&reply] {
    auto compared = std::make_shared<ComparedServer>(reply);
    return std::pair<ServerChild::Ports, std::shared_ptr<void>>({compared->port, 0}, compared);
  });
  const RoundTrips trips = round_trips(server.address(), request, seconds);
  const Throughput empty = throughput(server, kEmptyMethod, request, seconds, callers);
  const Throughput planned = throughput(server, kPlanMethod, request, seconds, callers);
  fmt::print("{}, replies of {} bytes\n", scenario, reply.size());
  fmt::print("  one caller   empty {}; PlanMotion {}; ratio of p50 {:.2f}\n", trips.empty.summary(),
             trips.planned.summary(), trips.planned.quantile(0.5) / trips.empty.quantile(0.5));
  fmt::print("               of PlanMotion without planning itself {}; ratio of p50 {:.2f}\n", trips.rest.summary(),
             trips.rest.quantile(0.5) / trips.empty.quantile(0.5));
  fmt::print("  {} callers   empty {:.0f}/s; PlanMotion {:.0f}/s; share {:.0f} %\n", callers, empty.answers,
             planned.answers, 100.0 * planned.answers / empty.answers);
  fmt::print(
      "  processor time of a call: empty, server {:.0f} us, client {:.0f} us; PlanMotion, server {:.0f} us, client "
      "{:.0f} us; planning by the clock {:.0f} us\n",
      1e6 * empty.server_seconds, 1e6 * empty.client_seconds, 1e6 * planned.server_seconds,
      1e6 * planned.client_seconds, 1e6 * planned.planning_seconds);
  return trips.planned.count() > 0 && planned.answers > 0.0 ? 0 : 1;
}

}  // namespace dualarm
