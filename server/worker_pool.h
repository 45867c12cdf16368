#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace dualarm {

/// A fixed number of threads behind a bounded queue. gRPC's own threads only hand work over: two of them serve all
/// calls, and a computation on one would keep health checks waiting.
class WorkerPool {
 public:
  using Task = std::function<void()>;

  /// thread_count >= 1; queue_capacity >= 0 tasks may wait while all threads are busy.
  WorkerPool(int thread_count, int queue_capacity);

  /// Runs what is still queued, then stops.
  ~WorkerPool();

  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// False, and the task is dropped, if all threads are busy and the queue is full. Never blocks for long. A task must
  /// not throw.
  [[nodiscard]] bool try_submit(Task task);

  /// Tasks that wait for a thread.
  std::size_t waiting() const;

 private:
  void work();

  const std::size_t most_tasks_;  // running and queued
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Task> queue_;
  std::size_t running_ = 0;
  bool stopping_ = false;
  std::vector<std::jthread> threads_;  // last: they use everything above
};

}  // namespace dualarm
