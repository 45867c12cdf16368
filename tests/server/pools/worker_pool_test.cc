#include "server/pools/worker_pool.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <future>
#include <latch>

namespace dualarm {
namespace {

TEST(WorkerPool, RunsWhatItAccepted) {
  std::atomic<int> done = 0;
  {
    WorkerPool pool({2, 100});
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
    WorkerPool pool({2, 1});
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
  WorkerPool pool({1, 0});
  for (int i = 0; i < 50; ++i) {
    std::promise<void> finished;
    // The thread counts as busy until it is back from the task, a moment after the promise is kept.
    while (!pool.try_submit([&finished] { finished.set_value(); })) std::this_thread::yield();
    finished.get_future().wait();
  }
}

TEST(WorkerPool, LetsPatientTasksWaitAndAFewOthersGoFirst) {
  std::promise<void> release;
  std::latch running(1);
  std::vector<char> order;
  {
    WorkerPool pool({1, 20});
    ASSERT_TRUE(pool.try_submit([&] {
      running.count_down();
      release.get_future().wait();
    }));
    running.wait();
    for (int i = 0; i < 30; ++i) pool.submit([&order] { order.push_back('p'); });
    for (int i = 0; i < 20; ++i) EXPECT_TRUE(pool.try_submit([&order] { order.push_back('u'); }));
    EXPECT_FALSE(pool.try_submit([] {}));
    EXPECT_EQ(pool.waiting(), 50u);
    release.set_value();
  }
  const std::string ran(order.begin(), order.end());
  EXPECT_EQ(ran,
            "uuuuuuu"
            "p"
            "uuuuuuuu"
            "p"
            "uuuuu" +
                std::string(28, 'p'));  // 8 in a row, with the one that held it
}

TEST(WorkerPool, ItsThreadsStandBackAsFarAsTheyAreTold) {
  std::promise<int> niceness;
  WorkerPool pool({1, 0, 7});
  ASSERT_TRUE(pool.try_submit([&niceness] { niceness.set_value(getpriority(PRIO_PROCESS, gettid())); }));
  EXPECT_EQ(niceness.get_future().get(), std::min(19, getpriority(PRIO_PROCESS, gettid()) + 7));
}

}  // namespace
}  // namespace dualarm
