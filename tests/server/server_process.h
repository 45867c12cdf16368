#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "tests/server/test_server.h"

namespace dualarm {

/// The real dualarm-server as a process of its own, on a free loopback port unless the arguments say otherwise.
class ServerProcess {
 public:
  explicit ServerProcess(std::vector<std::string> arguments = {});

  /// Kills it if it still runs.
  ~ServerProcess();

  ServerProcess(const ServerProcess&) = delete;
  ServerProcess& operator=(const ServerProcess&) = delete;

  /// Waits until it has written its port; "" if it ended before.
  std::string wait_for_address();

  /// Waits until it has said where its metrics are; "" if it ended before.
  std::string wait_for_metrics_address();

  pid_t pid() const { return pid_; }
  void signal(int number) const;

  /// Waits for its end: exit status, or -1 if a signal killed it.
  int wait_for_exit();

  /// What it has logged so far.
  std::string log() const;

 private:
  bool has_exited();

  TemporaryFolder folder_;
  pid_t pid_ = 0;
  int wait_status_ = 0;
};

}  // namespace dualarm
