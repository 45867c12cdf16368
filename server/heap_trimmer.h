#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

namespace dualarm {

/// Gives memory back to the system every few seconds, for as long as it lives. Searches and large messages leave holes
/// in the heaps of many threads; the C library keeps them, so that resident memory would creep towards the sum of what
/// each thread needed at its worst moment.
class HeapTrimmer {
 public:
  HeapTrimmer();
  ~HeapTrimmer();

  HeapTrimmer(const HeapTrimmer&) = delete;
  HeapTrimmer& operator=(const HeapTrimmer&) = delete;

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  bool stopping_ = false;
  std::jthread thread_;  // last: it uses everything above
};

}  // namespace dualarm
