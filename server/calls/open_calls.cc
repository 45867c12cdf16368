#include "server/calls/open_calls.h"

namespace dualarm {

bool OpenCalls::enter() {
  const std::lock_guard lock(mutex_);
  if (closed_) return false;
  ++count_;
  return true;
}

void OpenCalls::leave() {
  const std::lock_guard lock(mutex_);
  if (--count_ == 0 && closed_) none_.notify_all();
}

void OpenCalls::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
}

bool OpenCalls::wait_until_none(Clock::time_point deadline) {
  std::unique_lock lock(mutex_);
  return none_.wait_until(lock, deadline, [this] { return count_ == 0; });
}

}  // namespace dualarm
