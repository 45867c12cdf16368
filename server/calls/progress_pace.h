#pragma once

#include <chrono>

namespace dualarm {

/// When it is time to tell progress: news at most every 100 ms, and twice a second where there are none, so that a
/// caller hears something once a second even on a machine under load.
class ProgressPace {
 public:
  using Clock = std::chrono::steady_clock;

  static constexpr std::chrono::milliseconds kShortest{100};
  static constexpr std::chrono::milliseconds kLongest{500};

  explicit ProgressPace(Clock::time_point begin) : last_(begin) {}

  bool is_due(Clock::time_point now, bool has_news) const { return now - last_ >= (has_news ? kShortest : kLongest); }

  /// Progress is told.
  void told(Clock::time_point now) { last_ = now; }

 private:
  Clock::time_point last_;
};

}  // namespace dualarm
