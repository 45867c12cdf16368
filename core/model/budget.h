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

  explicit Budget(Clock::time_point deadline, std::function<bool()> cancelled = {})
      : deadline_(deadline), cancelled_(std::move(cancelled)) {}

  bool cancelled() const { return cancelled_ && cancelled_(); }
  bool exhausted() const { return cancelled() || (deadline_ != Clock::time_point::max() && Clock::now() >= deadline_); }

  /// For a step that others follow: until a share (0 to 1) of the time that is left from now on is over.
  Budget part(double share) const {
    if (deadline_ == Clock::time_point::max()) return *this;
    const auto now = Clock::now();
    return Budget(now + std::chrono::duration_cast<Clock::duration>(share * (deadline_ - now)), cancelled_);
  }

  /// For all but a last step that has to fit in: ends earlier by a share (0 to 1) of the time that is left from now on,
  /// by `most` at most.
  Budget leaving(double share, Clock::duration most) const {
    if (deadline_ == Clock::time_point::max()) return *this;
    const Clock::duration left = std::max(Clock::duration::zero(), deadline_ - Clock::now());
    return Budget(deadline_ - std::min(most, std::chrono::duration_cast<Clock::duration>(share * left)), cancelled_);
  }

 private:
  Clock::time_point deadline_ = Clock::time_point::max();
  std::function<bool()> cancelled_;
};

}  // namespace dualarm
