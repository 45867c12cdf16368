// SIGINT, SIGTERM and SIGHUP as a request to stop, so that a command unwinds and leaves nothing behind.
#pragma once

#include <signal.h>

#include <atomic>
#include <stop_token>
#include <thread>

namespace dualarm {

/// While it lives, the three signals do not end the process but request a stop of token(). Make it before any other
/// thread, on the main thread: threads inherit the blocked signals.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  std::stop_token token() const { return source_.get_token(); }

 private:
  sigset_t signals_;
  sigset_t signals_before_;
  std::stop_source source_;
  std::atomic<bool> over_ = false;
  std::thread watcher_;
};

}  // namespace dualarm
