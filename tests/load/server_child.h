#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "server/options.h"

namespace dualarm {

/// A server in a process of its own, forked from this one: make it before anything of gRPC. Ends with the object.
class ServerChild {
 public:
  /// Where it listens: its port and, where it has one, that of its metrics.
  struct Ports {
    int service = 0;
    int metrics = 0;
  };

  /// `start` runs in the child; it returns the ports and what has to live as long as the server.
  using Start = std::function<std::pair<Ports, std::shared_ptr<void>>()>;
  explicit ServerChild(const Start& start);

  /// A PlanningServer with core behind it, on a free port of loopback.
  explicit ServerChild(const ServerOptions& options);

  ~ServerChild();
  ServerChild(const ServerChild&) = delete;
  ServerChild& operator=(const ServerChild&) = delete;

  const std::string& address() const { return address_; }
  const std::string& metrics_address() const { return metrics_address_; }
  int pid() const { return pid_; }
  bool is_alive() const;

 private:
  std::string address_;
  std::string metrics_address_;
  int pid_ = 0;
  int leash_ = -1;  // the child ends when it is closed
};

/// Options of a server as it is by default, with so many workers and searches at once as the machine has processors.
ServerOptions default_options();

}  // namespace dualarm
