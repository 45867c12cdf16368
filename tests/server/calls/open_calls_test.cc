#include "server/calls/open_calls.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace dualarm {
namespace {

using Clock = OpenCalls::Clock;

TEST(OpenCalls, RefusesOnceClosed) {
  OpenCalls calls;
  EXPECT_TRUE(calls.enter());
  EXPECT_FALSE(calls.closed());
  calls.close();
  EXPECT_TRUE(calls.closed());
  EXPECT_FALSE(calls.enter());
}

TEST(OpenCalls, AreWaitedForUntilTheLastHasLeftOrPatienceEnds) {
  OpenCalls calls;
  EXPECT_TRUE(calls.wait_until_none(Clock::now()));
  ASSERT_TRUE(calls.enter());
  calls.close();
  EXPECT_FALSE(calls.wait_until_none(Clock::now() + std::chrono::milliseconds(1)));
  const std::jthread leaver([&calls] { calls.leave(); });
  EXPECT_TRUE(calls.wait_until_none(Clock::now() + std::chrono::hours(1)));
}

TEST(OpenCalls, NoneEntersUnseenWhileTheDoorCloses) {
  OpenCalls calls;
  std::atomic<int> inside = 0;
  std::vector<std::jthread> callers;
  for (int i = 0; i < 8; ++i) {
    callers.emplace_back([&] {
      while (calls.enter()) {
        ++inside;
        --inside;
        calls.leave();
      }
    });
  }
  calls.close();
  EXPECT_TRUE(calls.wait_until_none(Clock::now() + std::chrono::hours(1)));
  EXPECT_EQ(inside, 0);
}

}  // namespace
}  // namespace dualarm
