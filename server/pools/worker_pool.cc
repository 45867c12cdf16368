#include "server/pools/worker_pool.h"

#include <sys/resource.h>
#include <unistd.h>

#include <utility>

namespace dualarm {
namespace {

constexpr int kMostUrgentInARow = 8;  // while patient tasks wait: they get at least a ninth of the threads' turns

// More niceness is always permitted; 19 is the most there is. Linux takes a thread's id where others take a process.
void stand_back(int niceness) {
  const auto thread = static_cast<id_t>(gettid());
  if (niceness > 0) setpriority(PRIO_PROCESS, thread, getpriority(PRIO_PROCESS, thread) + niceness);
}

}  // namespace

WorkerPool::WorkerPool(Size size) : size_(size) {
  threads_.reserve(size.threads);
  for (int i = 0; i < size.threads; ++i) threads_.emplace_back([this] { work(); });
}

WorkerPool::~WorkerPool() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
}

bool WorkerPool::try_submit(Task task) {
  {
    const std::lock_guard lock(mutex_);
    const std::size_t idle = size_.threads - running_;
    if (urgent_.size() >= idle + size_.queue_capacity) return false;
    urgent_.push_back(std::move(task));
  }
  changed_.notify_one();
  return true;
}

void WorkerPool::submit(Task task) {
  {
    const std::lock_guard lock(mutex_);
    patient_.push_back(std::move(task));
  }
  changed_.notify_one();
}

std::size_t WorkerPool::waiting() const {
  const std::lock_guard lock(mutex_);
  return urgent_.size() + patient_.size();
}

// Under the lock.
std::optional<WorkerPool::Task> WorkerPool::next() {
  if (urgent_.empty() && patient_.empty()) return std::nullopt;
  const bool takes_patient = !patient_.empty() && (urgent_.empty() || urgent_in_a_row_ >= kMostUrgentInARow);
  auto& queue = takes_patient ? patient_ : urgent_;
  urgent_in_a_row_ = takes_patient ? 0 : urgent_in_a_row_ + 1;
  Task task = std::move(queue.front());
  queue.pop_front();
  return task;
}

void WorkerPool::work() {
  stand_back(size_.niceness);
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return stopping_ || !urgent_.empty() || !patient_.empty(); });
    std::optional<Task> task = next();
    if (!task) return;
    ++running_;
    lock.unlock();
    (*task)();
    task.reset();
    lock.lock();
    --running_;
  }
}

}  // namespace dualarm
