#include "server/planning_server.h"

#include <fmt/format.h>
#include <grpc/grpc.h>
#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/health_check_service_interface.h>
#include <grpcpp/server_builder.h>
#include <spdlog/spdlog.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "grpc/health/v1/health.pb.h"
#include "server/build_information.h"
#include "server/calls/call_observer.h"
#include "server/calls/malformed_requests.h"
#include "server/configuration_check.h"
#include "server/connections/accept.h"
#include "server/connections/hang_up.h"
#include "server/listen_address.h"
#include "server/logging/logs.h"
#include "server/metrics/process_figures.h"

namespace dualarm {
namespace {

std::chrono::nanoseconds nanoseconds(double seconds) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(seconds));
}

ServiceLimits limits_of(const ServerOptions& options) {
  constexpr std::size_t kMebibyte = 1024 * 1024;
  return {nanoseconds(options.planning_budget),
          static_cast<std::size_t>(options.search_memory_mib) * kMebibyte,
          options.max_streams,
          options.batch_in_flight,
          options.request,
          nanoseconds(1e-3 * options.inline_milliseconds)};
}

// gRPC stays up until the process ends. When its last object goes, version 1.51 waits for a poller that may be asleep
// for 10 s.
void keep_grpc_up() {
  static const bool kIsUp = (grpc_init(), true);
  (void)kIsUp;
}

void check(const ServerOptions& options) {
  const std::vector<std::string> complaints = complaints_about(options);
  if (!complaints.empty()) throw std::runtime_error(fmt::format("{}", fmt::join(complaints, "; ")));
  if (is_unix_address(options.listen) && is_unix_address_taken(options.listen)) {
    throw std::runtime_error(fmt::format("another server listens on {}", options.listen));
  }
}

// Both are for the process. Naming a message of health links its descriptors, without which reflection cannot show the
// service (grpc#36665).
void enable_health_and_reflection() {
  grpc::EnableDefaultHealthCheckService(true);
  grpc::reflection::InitProtoReflectionServerBuilderPlugin();
  grpc::health::v1::HealthCheckRequest::descriptor();
}

int milliseconds(std::chrono::milliseconds duration) { return static_cast<int>(duration.count()); }

// Whoever connects and says nothing, or has gone without a word, costs a file until it is noticed.
void limit_connections(grpc::ServerBuilder& builder, const ServerOptions& options) {
  constexpr std::chrono::seconds kLongestHandshake{10};
  constexpr std::chrono::seconds kSilenceBeforeAPing{60};
  constexpr std::chrono::seconds kLongestEcho{20};
  constexpr std::chrono::seconds kBetweenPingsOfClients{10};  // else gRPC ends a connection that is pinged idle
  constexpr int kStreamsBeside = 100;                         // health, reflection, calls that are refused
  // Of one connection; the client holds back what is more.
  builder.AddChannelArgument(GRPC_ARG_MAX_CONCURRENT_STREAMS,
                             options.max_streams + options.queue_capacity + kStreamsBeside);
  builder.AddChannelArgument(GRPC_ARG_SERVER_HANDSHAKE_TIMEOUT_MS, milliseconds(kLongestHandshake));
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIME_MS, milliseconds(kSilenceBeforeAPing));
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, milliseconds(kLongestEcho));
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_PERMIT_WITHOUT_CALLS, 1);
  builder.AddChannelArgument(GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS,
                             milliseconds(kBetweenPingsOfClients));
}

// Checked before anything is made of them.
const ServerOptions& checked(const ServerOptions& options) {
  check(options);
  return options;
}

void watch(Metrics& metrics, const WorkerPools& pools) {
  const std::map<std::string, const WorkerPool*> named = {
      {"quick", &pools.quick}, {"slow", &pools.slow}, {"search", &pools.search}, {"drawings", &pools.drawings}};
  for (const auto& [name, pool] : named) {
    metrics.watch("dualarm_pool_waiting", "Tasks that wait for a thread", {{"pool", name}},
                  [watched = pool] { return static_cast<double>(watched->waiting()); });
  }
  metrics.watch("process_resident_memory_bytes", "Resident memory", {}, resident_memory_bytes);
  metrics.watch("process_heap_bytes", "Heap, in use or kept for later", {{"state", "used"}}, used_heap_bytes);
  metrics.watch("process_heap_bytes", "Heap, in use or kept for later", {{"state", "free"}}, free_heap_bytes);
  metrics.watch("process_open_fds", "Open files and connections", {}, open_file_count);
  std::map<std::string, std::string> labels = {{"version", DUALARM_VERSION}};
  for (const Component& part : built_from()) labels[part.name] = part.version;
  metrics.watch("dualarm_build_info", "1; the labels say what was built from what", labels, [] { return 1.0; });
}

}  // namespace

PlanningServer::PlanningServer(const ServerOptions& options, PlanningFunctions functions)
    : log_(checked(options).log_format == "json"),
      security_(options),
      service_(std::move(functions), pools_, limits_of(options)),
      pools_(options),
      guarded_(service_, security_.admission(), open_calls_) {
  if (!options.replay_dir.empty()) keep_bugs_in(options.replay_dir, options.replay_limit);
  survive_many_connections();
  keep_grpc_up();
  enable_health_and_reflection();
  grpc::ServerBuilder builder;
  builder.AddChannelArgument(GRPC_ARG_ALLOW_REUSEPORT, 0);  // else a second server shares the port in silence
  limit_connections(builder, options);
  builder.SetMaxReceiveMessageSize(options.max_message_mib * 1024 * 1024);
  builder.AddListeningPort(options.listen, security_.credentials(), &port_);
  builder.RegisterService(&guarded_);
  std::vector<std::unique_ptr<grpc::experimental::ServerInterceptorFactoryInterface>> interceptors;
  interceptors.push_back(explain_malformed_requests());  // first: the observer sees what is sent in the end
  interceptors.push_back(
      observe_calls({log_, metrics_, security_.admission(), open_calls_, !options.tls_client_ca.empty()}));
  builder.experimental().SetInterceptorCreators(std::move(interceptors));
  server_ = builder.BuildAndStart();
  if (server_ == nullptr || port_ == 0) {
    throw std::runtime_error(fmt::format(
        "cannot listen on {}: the address is taken, not allowed, or not one of this machine", options.listen));
  }
  listen_ = options.listen;
  address_ = bound_address(options.listen, port_);
  watch(metrics_, pools_);
  if (!options.metrics_listen.empty()) endpoint_.emplace(options.metrics_listen, metrics_);
  server_->GetHealthCheckService()->SetServingStatus(wire::PlanningService::service_full_name(), true);
}

PlanningServer::~PlanningServer() { drain(std::chrono::nanoseconds::zero()); }

void PlanningServer::reload() {
  const Security::Reload reload = security_.reload();
  for (const std::string& news : reload.news) spdlog::info("reloaded: {}", news);
  for (const std::string& complaint : reload.complaints) spdlog::error("not reloaded: {}", complaint);
  metrics_.count_reload(reload.complaints.empty());
}

void PlanningServer::announce_end() { server_->GetHealthCheckService()->Shutdown(); }

void PlanningServer::drain(std::chrono::nanoseconds patience) {
  if (server_ == nullptr) return;
  announce_end();
  open_calls_.close();
  service_.drain();
  open_calls_.wait_until_none(OpenCalls::Clock::now() + patience);
  hang_up(listen_, port_);
  server_->Shutdown(std::chrono::system_clock::now());
  server_->Wait();
  server_.reset();
}

}  // namespace dualarm
