#include "tests/load/server_child.h"

#include <signal.h>
#include <spdlog/spdlog.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <memory>
#include <stdexcept>

#include "server/planning_server.h"

namespace dualarm {
namespace {

std::array<int, 2> new_pipe() {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  return ends;
}

[[noreturn]] void serve(const ServerChild::Start& start, int port_end, int leash) {
  spdlog::set_level(spdlog::level::err);
  const auto [ports, server] = start();
  if (write(port_end, &ports, sizeof ports) != sizeof ports) _exit(1);
  char byte = 0;
  while (read(leash, &byte, 1) > 0) {
  }
  _exit(0);
}

}  // namespace

ServerChild::ServerChild(const Start& start) {
  const auto port = new_pipe();
  const auto leash = new_pipe();
  pid_ = fork();
  if (pid_ == 0) {
    close(port[0]);
    close(leash[1]);
    serve(start, port[1], leash[0]);
  }
  close(port[1]);
  close(leash[0]);
  leash_ = leash[1];
  Ports ports;
  if (read(port[0], &ports, sizeof ports) != sizeof ports) throw std::runtime_error("the server does not start");
  close(port[0]);
  address_ = "127.0.0.1:" + std::to_string(ports.service);
  metrics_address_ = "127.0.0.1:" + std::to_string(ports.metrics);
}

ServerChild::ServerChild(const ServerOptions& options)
    : ServerChild([&options] {
        ServerOptions local = options;
        local.listen = "127.0.0.1:0";
        local.metrics_listen = "127.0.0.1:0";
        auto server = std::make_shared<PlanningServer>(local, core_functions());
        const std::string metrics = server->metrics_address();
        const Ports ports = {server->port(), std::stoi(metrics.substr(metrics.rfind(':') + 1))};
        return std::pair<Ports, std::shared_ptr<void>>(ports, server);
      }) {}

ServerChild::~ServerChild() {
  close(leash_);
  waitpid(pid_, nullptr, 0);
}

bool ServerChild::is_alive() const { return waitpid(pid_, nullptr, WNOHANG) == 0; }

ServerOptions default_options() {
  const char* const argv[] = {"dualarm-server"};
  return std::get<ServerOptions>(read_options(1, argv));
}

}  // namespace dualarm
