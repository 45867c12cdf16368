#include "server/calls/caller.h"

#include <algorithm>
#include <utility>

#include "server/logging/logs.h"

namespace dualarm {
namespace {

// What encoding the answer and sending it may take: a plan that is ready when the caller has gone is worth nothing.
constexpr std::chrono::milliseconds kAnswerMargin{20};

Caller::Clock::time_point on_steady_clock(std::chrono::system_clock::time_point time) {
  if (time == std::chrono::system_clock::time_point::max()) return Caller::Clock::time_point::max();
  const auto remaining = time - std::chrono::system_clock::now();
  constexpr std::chrono::hours kForever{24 * 365};  // gRPC's "no deadline" is far away, but not max() on every path
  return remaining > kForever ? Caller::Clock::time_point::max() : Caller::Clock::now() + remaining - kAnswerMargin;
}

double milliseconds(Caller::Clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

}  // namespace

Caller::Caller(std::string_view rpc, const grpc::CallbackServerContext& context)
    : rpc_(rpc), until_(on_steady_clock(context.deadline())) {}

Budget Caller::budget(std::chrono::nanoseconds at_most) const {
  return Budget(std::min(Clock::now() + at_most, until_), [this] { return has_left(); });
}

Budget Caller::budget(std::chrono::nanoseconds at_most, std::function<bool()> over) const {
  return Budget(std::min(Clock::now() + at_most, until_),
                [this, over = std::move(over)] { return has_left() || over(); });
}

void Caller::log(const Answer& answer) const {
  log_call({rpc_, answer.status.error_code(), answer.note, milliseconds(answer.waited),
            milliseconds(Clock::now() - since_)});
}

}  // namespace dualarm
