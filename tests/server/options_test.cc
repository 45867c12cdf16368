#include "server/options.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <vector>

namespace dualarm {
namespace {

std::variant<ServerOptions, ExitStatus> read(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "dualarm-server");
  return read_options(static_cast<int>(arguments.size()), arguments.data());
}

class EnvironmentVariable {
 public:
  EnvironmentVariable(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
  ~EnvironmentVariable() { unsetenv(name_); }
  EnvironmentVariable(const EnvironmentVariable&) = delete;
  EnvironmentVariable& operator=(const EnvironmentVariable&) = delete;

 private:
  const char* name_;
};

TEST(ReadOptions, HasDefaultsForEverything) {
  const auto options = std::get<ServerOptions>(read({}));
  EXPECT_EQ(options.listen, "127.0.0.1:50051");
  EXPECT_FALSE(options.allow_insecure_remote);
  EXPECT_EQ(options.max_message_mib, 4);
  EXPECT_GE(options.worker_threads, 1);
}

TEST(ReadOptions, TakesTheEnvironmentAndPrefersFlags) {
  const EnvironmentVariable listen("DUALARM_LISTEN", "127.0.0.1:1");
  const EnvironmentVariable queue("DUALARM_QUEUE_CAPACITY", "7");
  const EnvironmentVariable remote("DUALARM_ALLOW_INSECURE_REMOTE", "true");
  const auto options = std::get<ServerOptions>(read({"--listen", "unix:/tmp/x"}));
  EXPECT_EQ(options.listen, "unix:/tmp/x");
  EXPECT_EQ(options.queue_capacity, 7);
  EXPECT_TRUE(options.allow_insecure_remote);
}

TEST(ReadOptions, RefusesWhatMakesNoSense) {
  for (const auto& arguments : std::vector<std::vector<const char*>>{{"--worker-threads", "0"},
                                                                     {"--max-message-mib", "four"},
                                                                     {"--planning-budget", "-1"},
                                                                     {"--planning-budget", "nan"},
                                                                     {"--drain-seconds", "-nan"},
                                                                     {"--log-level", "loud"},
                                                                     {"--listen", "127.0.0.1:99999"},
                                                                     {"--port", "1"}}) {
    SCOPED_TRACE(arguments[0]);
    const auto result = read(arguments);
    ASSERT_TRUE(std::holds_alternative<ExitStatus>(result));
    EXPECT_EQ(std::get<ExitStatus>(result).value, 2);
  }
  const EnvironmentVariable threads("DUALARM_WORKER_THREADS", "none");
  EXPECT_EQ(std::get<ExitStatus>(read({})).value, 2);
}

TEST(ReadOptions, HelpAndVersionEndWithSuccess) {
  EXPECT_EQ(std::get<ExitStatus>(read({"--help"})).value, 0);
  EXPECT_EQ(std::get<ExitStatus>(read({"--version"})).value, 0);
}

}  // namespace
}  // namespace dualarm
