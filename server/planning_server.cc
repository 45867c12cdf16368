#include "server/planning_server.h"

#include <fmt/format.h>
#include <grpc/grpc.h>
#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/health_check_service_interface.h>
#include <grpcpp/server_builder.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "server/listen_address.h"
#include "server/malformed_requests.h"

namespace dualarm {
namespace {

std::chrono::nanoseconds nanoseconds(double seconds) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(seconds));
}

ServiceLimits limits_of(const ServerOptions& options) {
  constexpr std::size_t kMebibyte = 1024 * 1024;
  return {nanoseconds(options.planning_budget), static_cast<std::size_t>(options.search_memory_mib) * kMebibyte,
          options.max_streams, options.batch_in_flight, options.request};
}

// gRPC stays up until the process ends. When its last object goes, version 1.51 waits for a poller that may be asleep
// for 10 s.
void keep_grpc_up() {
  static const bool kIsUp = (grpc_init(), true);
  (void)kIsUp;
}

void check_address(const ServerOptions& options) {
  const std::string complaint = complaint_about_address(options.listen);
  if (!complaint.empty()) throw std::runtime_error(complaint);
  if (!is_local_address(options.listen) && !options.allow_insecure_remote) {
    throw std::runtime_error(
        fmt::format("{} can be reached from other machines, and this server speaks plaintext: listen on 127.0.0.1, or "
                    "say --allow-insecure-remote where something else protects it",
                    options.listen));
  }
  if (is_unix_address(options.listen) && is_unix_address_taken(options.listen)) {
    throw std::runtime_error(fmt::format("another server listens on {}", options.listen));
  }
}

}  // namespace

PlanningServer::PlanningServer(const ServerOptions& options, PlanningFunctions functions)
    : service_(std::move(functions), pools_, limits_of(options)), pools_(options) {
  check_address(options);
  keep_grpc_up();
  grpc::EnableDefaultHealthCheckService(true);
  grpc::reflection::InitProtoReflectionServerBuilderPlugin();
  grpc::ServerBuilder builder;
  builder.AddChannelArgument(GRPC_ARG_ALLOW_REUSEPORT, 0);  // else a second server shares the port in silence
  builder.SetMaxReceiveMessageSize(options.max_message_mib * 1024 * 1024);
  builder.AddListeningPort(options.listen, grpc::InsecureServerCredentials(), &port_);
  builder.RegisterService(&service_);
  std::vector<std::unique_ptr<grpc::experimental::ServerInterceptorFactoryInterface>> interceptors;
  interceptors.push_back(explain_malformed_requests());
  builder.experimental().SetInterceptorCreators(std::move(interceptors));
  server_ = builder.BuildAndStart();
  if (server_ == nullptr || port_ == 0) {
    throw std::runtime_error(fmt::format(
        "cannot listen on {}: the address is taken, not allowed, or not one of this machine", options.listen));
  }
  address_ = bound_address(options.listen, port_);
  server_->GetHealthCheckService()->SetServingStatus(wire::PlanningService::service_full_name(), true);
}

PlanningServer::~PlanningServer() { drain(std::chrono::nanoseconds::zero()); }

void PlanningServer::drain(std::chrono::nanoseconds patience) {
  if (server_ == nullptr) return;
  server_->GetHealthCheckService()->Shutdown();
  service_.drain();
  server_->Shutdown(std::chrono::system_clock::now() + patience);
  server_->Wait();
  server_.reset();
}

}  // namespace dualarm
