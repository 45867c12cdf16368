#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <utility>

namespace dualarm {

/// How long a computation may go on: until a deadline, or until its caller no longer wants the answer. Cheap to poll;
/// every loop that can be long does. Safe to poll from any thread if `cancelled` is.
class Budget {
 public:
  using Clock = std::chrono::steady_clock;

  /// Without limit and never cancelled.
  Budget() = default;

  /// `now` tells the time in the place of the steady clock: a thread's own processor time, or what a test counts.
  explicit Budget(Clock::time_point deadline, std::function<bool()> cancelled = {},
                  std::function<Clock::time_point()> now = {})
      : deadline_(deadline), cancelled_(std::move(cancelled)), now_(std::move(now)) {}

  bool cancelled() const { return cancelled_ && cancelled_(); }
  bool exhausted() const { return cancelled() || (deadline_ != Clock::time_point::max() && now() >= deadline_); }

  /// For a step that others follow: until a share (0 to 1) of the time that is left from now on is over.
  Budget part(double share) const {
    if (deadline_ == Clock::time_point::max()) return *this;
    const auto begin = now();
    return Budget(begin + std::chrono::duration_cast<Clock::duration>(share * (deadline_ - begin)), cancelled_, now_);
  }

  /// For all but a last step that has to fit in: ends earlier by a share (0 to 1) of the time that is left from now on,
  /// by `most` at most.
  Budget leaving(double share, Clock::duration most) const {
    if (deadline_ == Clock::time_point::max()) return *this;
    const Clock::duration left = std::max(Clock::duration::zero(), deadline_ - now());
    return Budget(deadline_ - std::min(most, std::chrono::duration_cast<Clock::duration>(share * left)), cancelled_,
                  now_);
  }

 private:
  Clock::time_point now() const { return now_ ? now_() : Clock::now(); }

  Clock::time_point deadline_ = Clock::time_point::max();
  std::function<bool()> cancelled_;
  std::function<Clock::time_point()> now_;
};

}  // namespace dualarm
