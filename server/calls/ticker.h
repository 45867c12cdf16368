#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <unordered_set>

namespace dualarm {

/// One thread that tells all who listen that time passes, so that no call needs a thread or a timer of its own. Sleeps
/// while nobody listens.
class Ticker {
 public:
  using Clock = std::chrono::steady_clock;

  class Listener {
   public:
    /// Every period, on the ticker's thread; keep it short, and do not call the ticker.
    virtual void tick(Clock::time_point now) = 0;

   protected:
    ~Listener() = default;
  };

  explicit Ticker(Clock::duration period);
  ~Ticker();

  Ticker(const Ticker&) = delete;
  Ticker& operator=(const Ticker&) = delete;

  void add(Listener& listener);

  /// No tick of this listener runs any more when this returns. Not under a lock that a tick takes.
  void remove(Listener& listener);

 private:
  void run();
  void tick_all(std::unique_lock<std::mutex>& lock);

  const Clock::duration period_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::unordered_set<Listener*> listeners_;
  bool stopping_ = false;
  std::jthread thread_;  // last: it uses everything above
};

}  // namespace dualarm
