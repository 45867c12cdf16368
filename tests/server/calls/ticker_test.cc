#include "server/calls/ticker.h"

#include <gtest/gtest.h>

#include <latch>

namespace dualarm {
namespace {

constexpr std::chrono::milliseconds kPeriod{2};

struct Counter final : Ticker::Listener {
  Counter() : reached(kWanted) {}

  void tick(Ticker::Clock::time_point now) override {
    EXPECT_GE(now, last);
    last = now;
    if (++count <= kWanted) reached.count_down();
  }

  int count = 0;
  static constexpr int kWanted = 3;
  Ticker::Clock::time_point last;
  std::latch reached;
};

TEST(Ticker, TellsAllWhoListenAgainAndAgain) {
  Ticker ticker(kPeriod);
  Counter first;
  Counter second;
  const auto begin = Ticker::Clock::now();
  ticker.add(first);
  ticker.add(second);
  first.reached.wait();
  second.reached.wait();
  EXPECT_GE(Ticker::Clock::now() - begin, Counter::kWanted * kPeriod);
  ticker.remove(first);
  ticker.remove(second);
}

TEST(Ticker, TellsNobodyWhoListensNoMore) {
  Ticker ticker(kPeriod);
  Counter kept;
  {
    Counter removed;
    ticker.add(removed);
    removed.reached.wait();
    ticker.remove(removed);
  }  // a tick from here on would be a use after free
  ticker.add(kept);
  kept.reached.wait();
  ticker.remove(kept);
}

}  // namespace
}  // namespace dualarm
