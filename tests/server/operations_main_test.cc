// The real binary in an operator's hands: signals, files, metrics, what it logs.
#include <gmock/gmock.h>
#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "tests/server/http_get.h"
#include "tests/server/paper_request.h"
#include "tests/server/server_process.h"
#include "tests/support/test_certificates.h"
#include "tests/support/thread_sanitizer.h"

namespace dualarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kToken[] = "correct-horse-battery-staple";
constexpr char kNewToken[] = "another-token-of-good-length";
constexpr char kWrongToken[] = "a-token-that-nobody-may-see";

class OperatedServer : public ::testing::Test {
 protected:
  OperatedServer() {
    certificates_.authority("root");
    certificates_.certificate("server", "root");
    write_file(path("tokens"), std::string("cell-4 ") + kToken + "\n");
  }

  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  std::vector<std::string> secured() const {
    return {"--tls-cert",  certificates_.pem("server"), "--tls-key", certificates_.key("server"), "--token-file",
            path("tokens")};
  }

  grpc::StatusCode plan(const std::string& address, const std::string& token, const std::string& root = "root") const {
    grpc::SslCredentialsOptions tls;
    tls.pem_root_certs = content_of(certificates_.pem(root));
    grpc::ChannelArguments arguments;
    arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
    const auto channel = grpc::CreateCustomChannel(address, grpc::SslCredentials(tls), arguments);
    grpc::ClientContext context;
    context.AddMetadata("authorization", "Bearer " + token);
    wire::PlanMotionRequest request = paper_request();
    request.mutable_options()->set_validate_only(true);
    wire::PlanMotionResponse response;
    return wire::PlanningService::NewStub(channel)->PlanMotion(&context, request, &response).error_code();
  }

  // Until the log says so; false where it has not after some seconds.
  static bool wait_for(const ServerProcess& process, const std::string& text) {
    for (int i = 0; i < 2000; ++i) {
      if (process.log().find(text) != std::string::npos) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }

  TemporaryFolder folder_;
  TestCertificates certificates_{folder_.path()};
};

TEST_F(OperatedServer, ReloadsCertificatesAndTokensOnSighup) {
  ServerProcess process(secured());
  const std::string address = process.wait_for_address();
  ASSERT_NE(address, "") << process.log();
  EXPECT_EQ(plan(address, kToken), grpc::StatusCode::OK);
  EXPECT_THAT(process.log(), HasSubstr("(TLS with /CN=server until "));

  certificates_.authority("next");
  certificates_.certificate("server", "next");
  write_file(path("tokens"), std::string("cell-5 ") + kNewToken + "\n");
  process.signal(SIGHUP);
  ASSERT_TRUE(wait_for(process, "reloaded: 1 tokens")) << process.log();
  EXPECT_EQ(plan(address, kNewToken, "next"), grpc::StatusCode::OK);
  EXPECT_EQ(plan(address, kToken, "next"), grpc::StatusCode::UNAUTHENTICATED);
  EXPECT_EQ(plan(address, kNewToken, "root"), grpc::StatusCode::UNAVAILABLE);

  write_file(certificates_.key("server"), "no key");
  write_file(path("tokens"), "");
  process.signal(SIGHUP);
  ASSERT_TRUE(wait_for(process, "it has no tokens")) << process.log();
  EXPECT_THAT(process.log(),
              HasSubstr("holds no private key in PEM without a passphrase; the certificates in use stay"));
  EXPECT_EQ(plan(address, kNewToken, "next"), grpc::StatusCode::OK);
  process.signal(SIGTERM);
  EXPECT_EQ(process.wait_for_exit(), 0);
}

TEST_F(OperatedServer, LogsNoSecretsNotEvenAtTheLowestLevel) {
  std::vector<std::string> arguments = secured();
  arguments.insert(arguments.end(), {"--log-level", "trace"});
  ServerProcess process(arguments);
  const std::string address = process.wait_for_address();
  ASSERT_NE(address, "") << process.log();
  EXPECT_EQ(plan(address, kToken), grpc::StatusCode::OK);
  EXPECT_EQ(plan(address, kWrongToken), grpc::StatusCode::UNAUTHENTICATED);
  write_file(path("tokens"), std::string("cell-4 ") + kNewToken + " not-a-number\n");
  process.signal(SIGHUP);
  ASSERT_TRUE(wait_for(process, "not reloaded: "));
  process.signal(SIGTERM);
  EXPECT_EQ(process.wait_for_exit(), 0);
  const std::string log = process.log();
  EXPECT_THAT(log, HasSubstr("PlanMotion OK request_id="));
  EXPECT_THAT(log, HasSubstr("caller=cell-4"));
  EXPECT_THAT(log, HasSubstr("PlanMotion UNAUTHENTICATED request_id="));
  for (const char* secret : {kToken, kNewToken, kWrongToken, "PRIVATE KEY"}) EXPECT_THAT(log, Not(HasSubstr(secret)));
  std::istringstream key(content_of(certificates_.key("server")));
  for (std::string line; std::getline(key, line);) EXPECT_THAT(log, Not(HasSubstr(line)));
}

TEST_F(OperatedServer, LogsOneJsonObjectALine) {
  DUALARM_SKIP_WITHOUT_PROTOBUF_MAPS();
  ServerProcess process({"--log-format", "json", "--log-level", "debug"});
  const std::string address = process.wait_for_address();
  ASSERT_NE(address, "") << process.log();
  const auto stub = wire::PlanningService::NewStub(grpc::CreateChannel(address, grpc::InsecureChannelCredentials()));
  grpc::ClientContext context;
  context.AddMetadata("x-request-id", "job-7");
  wire::PlanMotionResponse response;
  ASSERT_TRUE(stub->PlanMotion(&context, paper_request(), &response).ok());
  process.signal(SIGTERM);
  EXPECT_EQ(process.wait_for_exit(), 0);
  std::istringstream log(process.log());
  int calls = 0;
  for (std::string line; std::getline(log, line);) {
    google::protobuf::Struct object;
    ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(line, &object).ok()) << line;
    for (const char* key : {"time", "level", "message"}) EXPECT_EQ(object.fields().count(key), 1u) << line;
    if (object.fields().at("message").string_value() != "call") continue;
    ++calls;
    EXPECT_EQ(object.fields().at("method").string_value(), "PlanMotion");
    EXPECT_EQ(object.fields().at("code").string_value(), "OK");
    EXPECT_EQ(object.fields().at("request_id").string_value(), "job-7");
    EXPECT_EQ(object.fields().at("plan").string_value(), "METHOD_PASSAGE");
    EXPECT_GT(object.fields().at("total_ms").number_value(), object.fields().at("planning_ms").number_value());
  }
  EXPECT_EQ(calls, 1) << process.log();
}

TEST_F(OperatedServer, ServesMetricsOnAPortOfItsOwn) {
  ServerProcess process({"--metrics-listen", "0"});
  const std::string address = process.wait_for_address();
  ASSERT_NE(address, "") << process.log();
  const std::string metrics_address = process.wait_for_metrics_address();
  ASSERT_NE(metrics_address, "") << process.log();
  const auto stub = wire::PlanningService::NewStub(grpc::CreateChannel(address, grpc::InsecureChannelCredentials()));
  grpc::ClientContext context;
  wire::PlanMotionResponse response;
  ASSERT_TRUE(stub->PlanMotion(&context, paper_request(), &response).ok());
  const std::string metrics = http_get(metrics_address, "/metrics");
  EXPECT_THAT(metrics, HasSubstr("dualarm_plans_total{method=\"METHOD_PASSAGE\"} 1"));
  EXPECT_THAT(metrics, HasSubstr("dualarm_pool_waiting{"));
  EXPECT_THAT(metrics, HasSubstr("process_resident_memory_bytes "));
}

TEST_F(OperatedServer, SaysThatItEndsWhileItStillServes) {
  ServerProcess process({"--drain-notice", "60"});
  const std::string address = process.wait_for_address();
  ASSERT_NE(address, "") << process.log();
  const auto channel = grpc::CreateChannel(address, grpc::InsecureChannelCredentials());
  EXPECT_EQ(health_of(channel, ""), 1);
  process.signal(SIGTERM);
  ASSERT_TRUE(wait_for(process, "health says NOT_SERVING"));
  EXPECT_EQ(health_of(channel, ""), 2);
  EXPECT_EQ(health_of(channel, "dualarm.planning.v1.PlanningService"), 2);
  const auto stub = wire::PlanningService::NewStub(channel);
  grpc::ClientContext context;
  wire::PlanMotionResponse response;
  EXPECT_TRUE(stub->PlanMotion(&context, paper_request(), &response).ok());
  process.signal(SIGTERM);  // enough of that
  EXPECT_EQ(process.wait_for_exit(), 0);
}

TEST_F(OperatedServer, ChecksItsConfigurationAndEnds) {
  std::vector<std::string> arguments = secured();
  arguments.insert(arguments.end(), {"--check-config", "--queue-capacity", "7"});
  ServerProcess sound(arguments);
  EXPECT_EQ(sound.wait_for_exit(), 0);
  EXPECT_THAT(sound.log(), HasSubstr("queue-capacity = 7\n"));
  EXPECT_THAT(sound.log(), HasSubstr("drain-seconds = 10\n"));
  EXPECT_THAT(sound.log(), HasSubstr("the configuration is sound"));
  EXPECT_THAT(sound.log(), Not(HasSubstr(kToken)));
  ServerProcess bad({"--check-config", "--listen", "0.0.0.0:0", "--replay-dir", path("no/such")});
  EXPECT_EQ(bad.wait_for_exit(), 2);
  EXPECT_THAT(bad.log(), HasSubstr("--allow-insecure-remote"));
  EXPECT_THAT(bad.log(), HasSubstr("cannot write to"));
}

TEST_F(OperatedServer, RefusesToStartWhereOthersCouldReadTokens) {
  ServerProcess process({"--listen", "0.0.0.0:0", "--allow-insecure-remote", "--token-file", path("tokens")});
  EXPECT_EQ(process.wait_for_exit(), 1);
  EXPECT_THAT(process.log(), HasSubstr("could be read by others"));
}

TEST_F(OperatedServer, TheCommandLineRunsARequestThatMetABug) {
  ServerOptions options;
  options.replay_dir = path("replay");
  const TestServer server(functions_with_a_bug(), options);
  grpc::ClientContext context;
  wire::PlanMotionResponse response;
  ASSERT_EQ(server.stub()->PlanMotion(&context, paper_request(), &response).error_code(), grpc::StatusCode::INTERNAL);
  const auto kept = std::filesystem::directory_iterator(path("replay"))->path().string();
  const std::string command = DUALARM_PROGRAM " plan '" + kept + "' >'" + path("out") + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << content_of(path("out"));
  EXPECT_THAT(content_of(path("out")), HasSubstr("a verified plan"));
}

}  // namespace
}  // namespace dualarm
