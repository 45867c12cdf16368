// TLS, mutual TLS and tokens over real connections with real certificates.
#include <gmock/gmock.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>

#include <atomic>
#include <future>

#include "tests/server/error_detail.h"
#include "tests/server/paper_request.h"
#include "tests/server/test_server.h"
#include "tests/support/test_certificates.h"

namespace dualarm {
namespace {

using Code = grpc::StatusCode;

constexpr char kToken[] = "aaaaaaaaaaaaaaaa";

class Tls : public ::testing::Test {
 protected:
  Tls() {
    certificates_.authority("root");
    certificates_.authority("stranger");
    certificates_.certificate("server", "root");
    write_file(path("tokens"), std::string("cell-4 ") + kToken + " 1\n");
    options_.listen = "127.0.0.1:0";
    options_.tls_cert = certificates_.pem("server");
    options_.tls_key = certificates_.key("server");
  }

  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  /// A connection of its own that trusts this authority, and presents a certificate where one is named.
  std::shared_ptr<grpc::Channel> channel(const std::string& address, const std::string& root = "root",
                                         const std::string& own = "") const {
    grpc::SslCredentialsOptions tls;
    tls.pem_root_certs = content_of(certificates_.pem(root));
    if (!own.empty()) {
      tls.pem_cert_chain = content_of(certificates_.pem(own));
      tls.pem_private_key = content_of(certificates_.key(own));
    }
    grpc::ChannelArguments arguments;
    arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
    return grpc::CreateCustomChannel(address, grpc::SslCredentials(tls), arguments);
  }

  static grpc::Status plan(const std::shared_ptr<grpc::Channel>& channel, const std::string& token = "") {
    grpc::ClientContext context;
    if (!token.empty()) context.AddMetadata("authorization", "Bearer " + token);
    wire::PlanMotionResponse response;
    return wire::PlanningService::NewStub(channel)->PlanMotion(&context, paper_request(), &response);
  }

  TemporaryFolder folder_;
  TestCertificates certificates_{folder_.path()};
  ServerOptions options_;
};

TEST_F(Tls, ServesWhoeverTrustsItsAuthorityAndNoPlaintext) {
  const PlanningServer server(options_, quick_functions());
  const grpc::Status status = plan(channel(server.address()));
  EXPECT_TRUE(status.ok()) << status.error_message();
  EXPECT_EQ(plan(channel(server.address(), "stranger")).error_code(), Code::UNAVAILABLE);
  EXPECT_EQ(plan(grpc::CreateChannel(server.address(), grpc::InsecureChannelCredentials())).error_code(),
            Code::UNAVAILABLE);
}

TEST_F(Tls, AsksClientsForCertificatesOfItsAuthority) {
  certificates_.certificate("cell", "root");
  certificates_.certificate("intruder", "stranger");
  options_.tls_client_ca = certificates_.pem("root");
  const PlanningServer server(options_, quick_functions());
  EXPECT_TRUE(plan(channel(server.address(), "root", "cell")).ok());
  EXPECT_EQ(plan(channel(server.address())).error_code(), Code::UNAVAILABLE);
  EXPECT_EQ(plan(channel(server.address(), "root", "intruder")).error_code(), Code::UNAVAILABLE);
}

TEST_F(Tls, TakesNewCertificatesForNewConnectionsAndKeepsOldOnesServed) {
  PlanningServer server(options_, quick_functions());
  const auto standing = channel(server.address());
  ASSERT_TRUE(plan(standing).ok());
  certificates_.certificate("server", "stranger");
  EXPECT_TRUE(plan(channel(server.address())).ok());  // nobody has told it to look
  server.reload();
  EXPECT_TRUE(plan(channel(server.address(), "stranger")).ok());
  EXPECT_EQ(plan(channel(server.address())).error_code(), Code::UNAVAILABLE);
  EXPECT_TRUE(plan(standing).ok());
}

TEST_F(Tls, KeepsTheOldCertificatesAndTokensWhereTheNewAreNoGood) {
  options_.token_file = path("tokens");
  PlanningServer server(options_, quick_functions());
  for (const char* bad : {"", "no certificate", "-----BEGIN CERTIFICATE-----\nAAAA\n-----END CERTIFICATE-----\n"}) {
    write_file(options_.tls_cert, bad);
    write_file(path("tokens"), "cell-4 short\n");
    server.reload();
    EXPECT_TRUE(plan(channel(server.address()), kToken).ok()) << bad;
  }
  certificates_.certificate("server", "root");
  certificates_.certificate("other", "root");
  write_file(options_.tls_key, content_of(certificates_.key("other")));
  server.reload();
  EXPECT_TRUE(plan(channel(server.address()), kToken).ok());
}

TEST_F(Tls, ReloadsTokensWithoutCertificates) {
  options_.tls_cert = options_.tls_key = "";
  options_.token_file = path("tokens");
  PlanningServer server(options_, quick_functions());
  const auto plaintext = grpc::CreateChannel(server.address(), grpc::InsecureChannelCredentials());
  ASSERT_TRUE(plan(plaintext, kToken).ok());
  write_file(path("tokens"), "cell-5 bbbbbbbbbbbbbbbb\n");
  server.reload();
  EXPECT_EQ(plan(plaintext, kToken).error_code(), Code::UNAUTHENTICATED);
  EXPECT_TRUE(plan(plaintext, "bbbbbbbbbbbbbbbb").ok());
}

// Every RPC, so that none is forgotten: each must be in the switch.
grpc::Status call(wire::PlanningService::Stub& stub, const std::string& method, grpc::ClientContext& context) {
  wire::GetForbiddenRegionResponse region;
  wire::GetPhasePortraitResponse portrait;
  wire::PlanMotionResponse plan;
  wire::VerifyMotionResponse verification;
  if (method == "PlanMotion") return stub.PlanMotion(&context, paper_request(), &plan);
  if (method == "VerifyMotion") return stub.VerifyMotion(&context, paper_verify_request(), &verification);
  if (method == "GetForbiddenRegion") return stub.GetForbiddenRegion(&context, {}, &region);
  if (method == "GetPhasePortrait") return stub.GetPhasePortrait(&context, {}, &portrait);
  if (method == "PlanMotionStream") {
    const auto stream = stub.PlanMotionStream(&context, {});
    for (wire::PlanMotionStreamResponse event; stream->Read(&event);) continue;
    return stream->Finish();
  }
  if (method == "PlanMotionBatch") return stub.PlanMotionBatch(&context)->Finish();
  return {Code::DO_NOT_USE, "this test does not know " + method};
}

TEST_F(Tls, NoMethodAnswersWithoutAToken) {
  options_.token_file = path("tokens");
  const PlanningServer server(options_, quick_functions());
  const auto stub = wire::PlanningService::NewStub(channel(server.address()));
  const auto* service = wire::PlanMotionRequest::descriptor()->file()->FindServiceByName("PlanningService");
  for (int i = 0; i < service->method_count(); ++i) {
    const std::string& method = service->method(i)->name();
    SCOPED_TRACE(method);
    grpc::ClientContext without, with_a_wrong_one, with;
    const grpc::Status missing = call(*stub, method, without);
    EXPECT_EQ(missing.error_code(), Code::UNAUTHENTICATED) << missing.error_message();
    EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(missing).reason(), "TOKEN_MISSING");
    EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(missing).domain(), "dualarm");
    with_a_wrong_one.AddMetadata("authorization", "Bearer bbbbbbbbbbbbbbbb");
    const grpc::Status unknown = call(*stub, method, with_a_wrong_one);
    EXPECT_EQ(unknown.error_code(), Code::UNAUTHENTICATED);
    EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(unknown).reason(), "TOKEN_UNKNOWN");
    with.AddMetadata("authorization", std::string("Bearer ") + kToken);
    with.set_deadline(std::chrono::system_clock::now() + std::chrono::seconds(1));
    const grpc::Status entered = call(*stub, method, with);
    EXPECT_NE(entered.error_code(), Code::UNAUTHENTICATED) << entered.error_message();
    EXPECT_NE(entered.error_code(), Code::DO_NOT_USE) << entered.error_message();
  }
}

TEST_F(Tls, HealthIsOpenToAll) {
  options_.token_file = path("tokens");
  const PlanningServer server(options_, quick_functions());
  EXPECT_EQ(health_of(channel(server.address()), "dualarm.planning.v1.PlanningService"), 1);
}

TEST_F(Tls, LimitsTheCallsOfATokenAtOnce) {
  options_.token_file = path("tokens");
  std::promise<void> begun, release;
  std::atomic<int> plans = 0;
  const PlanningFunctions functions =
      functions_with(quick_planning([&](const Problem&, const Budget&, const Observer&) {
        if (++plans == 1) {
          begun.set_value();
          release.get_future().wait();
        }
        return Outcome{Undecided{}, {}};
      }));
  const PlanningServer server(options_, functions);
  const auto connection = channel(server.address());
  auto running = std::async(std::launch::async, [&] { return plan(connection, kToken); });
  begun.get_future().wait();
  const grpc::Status refused = plan(connection, kToken);
  EXPECT_EQ(refused.error_code(), Code::RESOURCE_EXHAUSTED);
  EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(refused).reason(), "TOO_MANY_CALLS");
  EXPECT_GT(detail_of<google::rpc::RetryInfo>(refused).retry_delay().nanos(), 0);
  release.set_value();
  EXPECT_TRUE(running.get().ok());
  EXPECT_TRUE(plan(connection, kToken).ok());  // its place is free again
}

}  // namespace
}  // namespace dualarm
