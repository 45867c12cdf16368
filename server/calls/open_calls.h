#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>

namespace dualarm {

/// The calls that are being answered, and whether more are taken. From any thread.
class OpenCalls {
 public:
  using Clock = std::chrono::steady_clock;

  /// A call begins: it is counted until it leaves. False once closed: then it is not, and is to be refused.
  bool enter();
  void leave();

  /// From now on no call enters.
  void close();
  bool closed() const { return closed_; }

  /// Waits until all that entered have left; false where that takes longer than until `deadline`.
  bool wait_until_none(Clock::time_point deadline);

 private:
  std::mutex mutex_;
  std::condition_variable none_;
  int count_ = 0;
  std::atomic<bool> closed_ = false;  // written under the lock
};

}  // namespace dualarm
