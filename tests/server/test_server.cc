#include "tests/server/test_server.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/generic/generic_stub.h>
#include <stdlib.h>

#include <future>
#include <stdexcept>

namespace dualarm {

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "dualarm-test-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

ServerOptions listening_on(const std::string& address) {
  ServerOptions options;
  options.listen = address;
  return options;
}

ServerOptions patient_options() {
  ServerOptions options;
  options.planning_budget = 30.0;
  return options;
}

TestServer::TestServer(PlanningFunctions functions, ServerOptions options, bool tries_inline) {
  options.listen = address();
  if (!tries_inline) options.inline_milliseconds = 0.0;  // fakes of planning block, and heed no budget
  server_ = std::make_unique<PlanningServer>(options, std::move(functions));
}

std::shared_ptr<grpc::Channel> TestServer::channel() const {
  return grpc::CreateChannel(address(), grpc::InsecureChannelCredentials());
}

std::unique_ptr<wire::PlanningService::Stub> TestServer::stub() const {
  return wire::PlanningService::NewStub(channel());
}

int health_of(const std::shared_ptr<grpc::Channel>& channel, const std::string& service) {
  // HealthCheckRequest { string service = 1 } and HealthCheckResponse { status = 1 }, in protobuf's own bytes.
  const grpc::Slice request_bytes(std::string("\x0a") + static_cast<char>(service.size()) + service);
  const grpc::ByteBuffer request(&request_bytes, 1);
  grpc::ByteBuffer response;
  grpc::ClientContext context;
  std::promise<grpc::Status> done;
  grpc::GenericStub(channel).UnaryCall(&context, "/grpc.health.v1.Health/Check", {}, &request, &response,
                                       [&done](grpc::Status status) { done.set_value(std::move(status)); });
  grpc::Slice bytes;
  if (!done.get_future().get().ok() || !response.DumpToSingleSlice(&bytes).ok()) return -1;
  return bytes.size() < 2 ? 0 : bytes.begin()[1];
}

}  // namespace dualarm
