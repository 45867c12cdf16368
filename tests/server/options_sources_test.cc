// Where options come from: flags, environment, file; and that the documents know all of them.
#include <gmock/gmock.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <cctype>
#include <filesystem>
#include <sstream>
#include <vector>

#include "server/options.h"
#include "tests/server/test_server.h"
#include "tests/support/test_certificates.h"

namespace dualarm {
namespace {

using ::testing::HasSubstr;

class OptionSources : public ::testing::Test {
 protected:
  ~OptionSources() override {
    for (const char* name : {"DUALARM_CONFIG", "DUALARM_LISTEN", "DUALARM_QUEUE_CAPACITY"}) unsetenv(name);
  }

  std::string file(const std::string& text) const {
    const std::string path = (folder_.path() / "server.toml").string();
    write_file(path, text);
    return path;
  }

  static std::variant<ServerOptions, ExitStatus> read(std::vector<std::string> arguments) {
    std::vector<const char*> pointers = {"dualarm-server"};
    for (const std::string& argument : arguments) pointers.push_back(argument.c_str());
    return read_options(static_cast<int>(pointers.size()), pointers.data());
  }

  TemporaryFolder folder_;
};

TEST_F(OptionSources, AFileGivesAnyOption) {
  const auto options = std::get<ServerOptions>(
      read({"--config", file("# a comment\nlisten = \"127.0.0.1:7\"\nqueue-capacity = 3\nplanning-budget = 2.5\n"
                             "allow-insecure-remote = true\nmetrics-listen = \"9464\"\nlog-format = 'json'\n")}));
  EXPECT_EQ(options.listen, "127.0.0.1:7");
  EXPECT_EQ(options.queue_capacity, 3);
  EXPECT_EQ(options.planning_budget, 2.5);
  EXPECT_TRUE(options.allow_insecure_remote);
  EXPECT_EQ(options.metrics_listen, "9464");
  EXPECT_EQ(options.log_format, "json");
}

TEST_F(OptionSources, AFlagWinsOverTheEnvironmentAndThatOverTheFile) {
  setenv("DUALARM_CONFIG", file("listen = \"127.0.0.1:1\"\nqueue-capacity = 1\nworker-threads = 1\n").c_str(), 1);
  setenv("DUALARM_LISTEN", "127.0.0.1:2", 1);
  setenv("DUALARM_QUEUE_CAPACITY", "2", 1);
  const auto options = std::get<ServerOptions>(read({"--listen", "127.0.0.1:3"}));
  EXPECT_EQ(options.listen, "127.0.0.1:3");
  EXPECT_EQ(options.queue_capacity, 2);
  EXPECT_EQ(options.worker_threads, 1);
}

TEST_F(OptionSources, AFileThatIsMissingOrWrongIsRefused) {
  EXPECT_EQ(std::get<ExitStatus>(read({"--config", "/no/such/file"})).value, kUsageError);
  EXPECT_EQ(std::get<ExitStatus>(read({"--config", "/dev/zero"})).value, kUsageError) << "it has no end";
  const std::string pipe = file("");
  std::filesystem::remove(pipe);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(std::get<ExitStatus>(read({"--config", pipe})).value, kUsageError) << "nobody writes into it";
  std::filesystem::remove(pipe);
  setenv("DUALARM_CONFIG", "/no/such/file", 1);
  EXPECT_EQ(std::get<ExitStatus>(read({})).value, kUsageError);
  unsetenv("DUALARM_CONFIG");
  for (const char* text :
       {"queue-capasity = 3\n", "queue-capacity = many\n", "queue-capacity = -1\n",
        "[section]\nlisten = \"127.0.0.1:1\"\n", "check-config = true\n", "metrics-listen = \"nowhere\"\n"}) {
    const auto read_back = read({"--config", file(text)});
    ASSERT_TRUE(std::holds_alternative<ExitStatus>(read_back)) << text;
    EXPECT_EQ(std::get<ExitStatus>(read_back).value, kUsageError) << text;
  }
}

TEST_F(OptionSources, CertificateAndKeyComeTogether) {
  EXPECT_EQ(std::get<ExitStatus>(read({"--tls-cert", "c.pem"})).value, kUsageError);
  EXPECT_EQ(std::get<ExitStatus>(read({"--tls-key", "k.pem"})).value, kUsageError);
  EXPECT_EQ(std::get<ExitStatus>(read({"--tls-client-ca", "ca.pem"})).value, kUsageError);
  EXPECT_TRUE(std::holds_alternative<ServerOptions>(read({"--tls-cert", "c.pem", "--tls-key", "k.pem"})));
}

TEST_F(OptionSources, EnvironmentVariablesAreNamedAfterTheirFlags) {
  std::istringstream lines(options_table());
  int rows = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t dashes = line.find("`--");
    if (dashes == std::string::npos) continue;
    ++rows;
    std::string name = line.substr(dashes + 3, line.find('`', dashes + 1) - dashes - 3);
    for (char& character : name) character = character == '-' ? '_' : static_cast<char>(std::toupper(character));
    EXPECT_THAT(line, HasSubstr("`DUALARM_" + name + "`"));
  }
  EXPECT_GE(rows, 20);
}

// Where this fails: dualarm-server --options-table.
TEST_F(OptionSources, TheDocumentHasTheTableOfTheProgram) {
  const std::string document = content_of(DUALARM_SOURCE_DIR "/docs/operations.md");
  const std::string table = options_table();
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) EXPECT_THAT(document, HasSubstr(line + "\n"));
  EXPECT_NE(document.find("\n\n" + table + "\n"), std::string::npos) << "rows of other options, or in another order";
}

}  // namespace
}  // namespace dualarm
