#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace dualarm {

/// A fixed number of threads behind two queues: a bounded one for callers who would rather be refused than wait long,
/// and one for callers who wait and bound themselves what they hand over. gRPC's own threads only hand work over: two
/// of them serve all calls, and a computation on one would keep health checks waiting.
class WorkerPool {
 public:
  using Task = std::function<void()>;

  struct Size {
    int threads = 1;         ///< at least 1
    int queue_capacity = 0;  ///< tasks that may wait while all threads are busy, at least 0
    int niceness = 0;        ///< of the threads, 0 to 19: how far they stand back behind others
  };

  explicit WorkerPool(Size size);

  /// Runs what is still queued, then stops.
  ~WorkerPool();

  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// False, and the task is dropped, if all threads are busy and the queue is full. Never blocks for long. A task must
  /// not throw.
  [[nodiscard]] bool try_submit(Task task);

  /// For tasks that may wait as long as it takes: the others go first, but a few of them at most between two of these.
  void submit(Task task);

  /// Tasks that wait for a thread, in both queues.
  std::size_t waiting() const;

 private:
  void work();
  std::optional<Task> next();

  const Size size_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Task> urgent_;
  std::deque<Task> patient_;
  std::size_t running_ = 0;
  int urgent_in_a_row_ = 0;
  bool stopping_ = false;
  std::vector<std::jthread> threads_;  // last: they use everything above
};

}  // namespace dualarm
