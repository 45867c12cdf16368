#pragma once

#include <grpcpp/channel.h>

#include <filesystem>
#include <memory>
#include <string>

#include "server/planning_server.h"
#include "tests/server/fake_planning.h"

namespace dualarm {

/// A folder of its own under the system's temporary one; gone with its owner.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Default options but for the address, or for a planning budget that only a failing test uses up.
ServerOptions listening_on(const std::string& address);
ServerOptions patient_options();

/// A PlanningServer on a private unix socket, in this process.
class TestServer {
 public:
  explicit TestServer(PlanningFunctions functions = quick_functions(), ServerOptions options = {},
                      bool tries_inline = false);

  PlanningServer& server() { return *server_; }
  std::string address() const { return "unix:" + (folder_.path() / "socket").string(); }
  std::shared_ptr<grpc::Channel> channel() const;
  std::unique_ptr<wire::PlanningService::Stub> stub() const;

 private:
  TemporaryFolder folder_;
  std::unique_ptr<PlanningServer> server_;
};

/// The server's health for a service name as it is on the wire: 0 unknown, 1 SERVING, 2 NOT_SERVING; -1 if the call
/// failed.
int health_of(const std::shared_ptr<grpc::Channel>& channel, const std::string& service);

}  // namespace dualarm
