#include "server/calls/ticker.h"

#include <vector>

namespace dualarm {

Ticker::Ticker(Clock::duration period) : period_(period), thread_([this] { run(); }) {}

Ticker::~Ticker() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
}

void Ticker::add(Listener& listener) {
  bool is_first = false;
  {
    const std::lock_guard lock(mutex_);
    is_first = listeners_.empty();
    listeners_.insert(&listener);
  }
  if (is_first) changed_.notify_all();
}

void Ticker::remove(Listener& listener) {
  const std::lock_guard lock(mutex_);
  listeners_.erase(&listener);
}

void Ticker::run() {
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    changed_.wait(lock, [this] { return stopping_ || !listeners_.empty(); });
    const auto next = Clock::now() + period_;
    if (changed_.wait_until(lock, next, [this] { return stopping_; })) return;
    tick_all(lock);
  }
}

// The lock is given back between two listeners: with a thousand of them nobody waits for all to be told.
void Ticker::tick_all(std::unique_lock<std::mutex>& lock) {
  const std::vector<Listener*> listeners(listeners_.begin(), listeners_.end());
  for (Listener* listener : listeners) {
    if (listeners_.contains(listener)) listener->tick(Clock::now());
    lock.unlock();
    lock.lock();
  }
}

}  // namespace dualarm
