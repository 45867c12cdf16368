#include "server/worker_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <latch>

namespace dualarm {
namespace {

TEST(WorkerPool, RunsWhatItAccepted) {
  std::atomic<int> done = 0;
  {
    WorkerPool pool(2, 100);
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(pool.try_submit([&done] { ++done; }));
  }
  EXPECT_EQ(done, 100);
}

TEST(WorkerPool, RefusesWhenThreadsAndQueueAreFull) {
  std::latch running(2);
  std::promise<void> release;
  const std::shared_future<void> released = release.get_future().share();
  std::atomic<int> done = 0;
  {
    WorkerPool pool(2, 1);
    const auto block = [&] {
      running.count_down();
      released.wait();
      ++done;
    };
    ASSERT_TRUE(pool.try_submit(block));
    ASSERT_TRUE(pool.try_submit(block));
    running.wait();
    EXPECT_TRUE(pool.try_submit([&done] { ++done; }));
    EXPECT_FALSE(pool.try_submit([&done] { ++done; }));
    release.set_value();
  }
  EXPECT_EQ(done, 3);
}

TEST(WorkerPool, AcceptsAgainOnceThereIsRoom) {
  WorkerPool pool(1, 0);
  for (int i = 0; i < 50; ++i) {
    std::promise<void> finished;
    // The thread counts as busy until it is back from the task, a moment after the promise is kept.
    while (!pool.try_submit([&finished] { finished.set_value(); })) std::this_thread::yield();
    finished.get_future().wait();
  }
}

}  // namespace
}  // namespace dualarm
