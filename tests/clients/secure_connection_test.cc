// The real program against a real server that asks for TLS, certificates and tokens.
#include <gmock/gmock.h>

#include "tests/clients/program_run.h"
#include "tests/server/server_process.h"
#include "tests/support/test_certificates.h"

namespace dualarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kToken[] = "correct-horse-battery-staple";
constexpr char kScenario[] = DUALARM_SOURCE_DIR "/scenarios/paper_case1.json";

class SecureConnection : public ::testing::Test {
 protected:
  SecureConnection() {
    certificates_.authority("root");
    certificates_.authority("stranger");
    certificates_.certificate("server", "root");
    certificates_.certificate("cell", "root");
    write_file(path("tokens"), std::string("cell-4 ") + kToken + "\n");
    write_file(path("token"), std::string(kToken) + "\n");
    write_file(path("wrong"), "a-token-that-nobody-knows\n");
  }

  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  ProgramResult run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), DUALARM_PROGRAM);
    return ProgramRun(arguments, {"TMPDIR=" + folder_.path().string()}, folder_.path().string()).wait();
  }

  std::vector<std::string> serving(std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--tls-cert", certificates_.pem("server"), "--tls-key", certificates_.key("server")});
    return more;
  }

  TemporaryFolder folder_;
  TestCertificates certificates_{folder_.path()};
};

TEST_F(SecureConnection, EveryCommandSpeaksTlsAndSendsItsToken) {
  ServerProcess server(serving({"--token-file", path("tokens")}));
  const std::string address = server.wait_for_address();
  ASSERT_NE(address, "") << server.log();
  const std::vector<std::string> secured = {"--server",     address,      "--tls-ca", certificates_.pem("root"),
                                            "--token-file", path("token")};
  const std::string answer = path("answer.json");
  for (std::vector<std::string> command : {std::vector<std::string>{"plan", kScenario, "--output", answer},
                                           {"verify", kScenario, "--plan", answer},
                                           {"region", kScenario},
                                           {"portrait", kScenario, "--arm", "arm1"},
                                           {"health"}}) {
    command.insert(command.end(), secured.begin(), secured.end());
    const ProgramResult result = run(command);
    EXPECT_EQ(result.exit_status, 0) << command[0] << ": " << result.err;
  }
  EXPECT_THAT(server.log(), HasSubstr("caller=cell-4"));
}

TEST_F(SecureConnection, SaysWhatKeepsItOut) {
  ServerProcess server(serving({"--token-file", path("tokens")}));
  const std::string address = server.wait_for_address();
  ASSERT_NE(address, "") << server.log();
  const ProgramResult no_token = run({"plan", kScenario, "--server", address, "--tls-ca", certificates_.pem("root")});
  EXPECT_EQ(no_token.exit_status, 2);
  EXPECT_THAT(no_token.err, HasSubstr("this server asks for a token"));
  const ProgramResult wrong = run(
      {"plan", kScenario, "--server", address, "--tls-ca", certificates_.pem("root"), "--token-file", path("wrong")});
  EXPECT_EQ(wrong.exit_status, 2);
  EXPECT_THAT(wrong.err, Not(HasSubstr("nobody-knows")));
  const ProgramResult stranger =
      run({"health", "--server", address, "--tls-ca", certificates_.pem("stranger"), "--timeout", "2"});
  EXPECT_EQ(stranger.exit_status, 5) << stranger.err;
  const ProgramResult plaintext = run({"health", "--server", address, "--timeout", "2"});
  EXPECT_EQ(plaintext.exit_status, 5) << plaintext.err;
}

TEST_F(SecureConnection, PresentsItsCertificateWhereOneIsAskedFor) {
  ServerProcess server(serving({"--tls-client-ca", certificates_.pem("root")}));
  const std::string address = server.wait_for_address();
  ASSERT_NE(address, "") << server.log();
  EXPECT_EQ(run({"plan", kScenario, "--server", address, "--tls-ca", certificates_.pem("root"), "--tls-cert",
                 certificates_.pem("cell"), "--tls-key", certificates_.key("cell")})
                .exit_status,
            0);
  EXPECT_THAT(server.log(), HasSubstr("(mutual TLS with "));
  EXPECT_THAT(server.log(), HasSubstr("caller="));
  EXPECT_EQ(run({"health", "--server", address, "--tls-ca", certificates_.pem("root"), "--timeout", "2"}).exit_status,
            5);
}

TEST_F(SecureConnection, SendsNoTokenWhereOthersCouldReadIt) {
  for (const char* remote : {"planner.example.com:50051", "192.0.2.1:50051", "127.example.com:50051"}) {
    const ProgramResult result = run({"health", "--server", remote, "--token-file", path("token")});
    EXPECT_EQ(result.exit_status, 2);
    EXPECT_THAT(result.err, HasSubstr("could be read by others")) << remote;
  }
}

TEST_F(SecureConnection, WantsFilesThatItCanRead) {
  const ProgramResult no_authority = run({"health", "--server", "127.0.0.1:1", "--tls-ca", path("none")});
  EXPECT_EQ(no_authority.exit_status, 2);
  EXPECT_THAT(no_authority.err, HasSubstr(path("none") + ": cannot be read"));
  write_file(path("two words"), "two words");
  const ProgramResult no_token = run({"health", "--server", "127.0.0.1:1", "--token-file", path("two words")});
  EXPECT_EQ(no_token.exit_status, 2);
  EXPECT_THAT(no_token.err, HasSubstr("holds no token"));
  EXPECT_EQ(run({"health", "--token-file", path("token")}).exit_status, 2);  // there is no server to send it to
}

}  // namespace
}  // namespace dualarm
