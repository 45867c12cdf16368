#include "clients/cpp/local_server.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <fstream>
#include <thread>

namespace dualarm {
namespace {

using Clock = std::chrono::steady_clock;

// A child that writes its process id into `log` and then sleeps; 0 if it never does.
pid_t id_in(const std::filesystem::path& log) {
  for (const auto begin = Clock::now(); Clock::now() - begin < std::chrono::seconds(20);) {
    pid_t id = 0;
    if (std::ifstream(log) >> id) return id;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return 0;
}

TEST(ChildProcess, EndsAtOnceEvenWhereItIgnoresTheRequest) {
  for (const std::string trap : {"", "trap '' TERM; "}) {
    SCOPED_TRACE(trap);
    const PrivateFolder folder;
    const auto log = folder.path() / "log";
    pid_t id = 0;
    Clock::time_point begin;
    {
      const ChildProcess child("/bin/sh", {"-c", trap + "echo $$; exec sleep 60"}, log);
      id = id_in(log);
      ASSERT_GT(id, 0);
      begin = Clock::now();
    }
    EXPECT_LT(Clock::now() - begin, std::chrono::seconds(2));
    EXPECT_EQ(kill(id, 0), -1);
  }
}

}  // namespace
}  // namespace dualarm
