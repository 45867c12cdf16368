// A stranger who opens connections until no file is free.
#include <gmock/gmock.h>
#include <grpcpp/create_channel.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <thread>
#include <vector>

#include "tests/server/server_process.h"

namespace dualarm {
namespace {

constexpr rlim_t kFilesOfTheServer = 64;
constexpr int kConnections = 200;

class Connections {
 public:
  explicit Connections(int port) : port_(port) {}
  ~Connections() {
    for (const int file : files_) close(file);
  }
  Connections(const Connections&) = delete;
  Connections& operator=(const Connections&) = delete;

  bool open() {
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port_));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    files_.push_back(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    return connect(files_.back(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  }

 private:
  int port_;
  std::vector<int> files_;
};

TEST(ManyConnections, LeaveTheServerReachableOnceTheyAreGone) {
  ServerProcess process;
  const std::string address = process.wait_for_address();
  ASSERT_NE(address, "") << process.log();
  const rlimit few = {kFilesOfTheServer, kFilesOfTheServer};
  ASSERT_EQ(prlimit(process.pid(), RLIMIT_NOFILE, &few, nullptr), 0);
  {
    Connections connections(std::stoi(address.substr(address.rfind(':') + 1)));
    for (int i = 0; i < kConnections; ++i) ASSERT_TRUE(connections.open()) << i;
    while (process.log().find("no files are left") == std::string::npos) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  int health = -1;
  for (int i = 0; i < 1000 && health != 1; ++i) {  // the server has to notice first that they are gone
    health = health_of(grpc::CreateChannel(address, grpc::InsecureChannelCredentials()), "");
    if (health != 1) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(health, 1) << process.log();
}

}  // namespace
}  // namespace dualarm
