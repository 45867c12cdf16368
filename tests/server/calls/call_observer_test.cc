#include "server/calls/call_observer.h"

#include <gmock/gmock.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <sstream>
#include <stdexcept>

#include "server/logging/request_id.h"
#include "tests/server/paper_request.h"
#include "tests/server/test_server.h"

namespace dualarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// What a server that begins while this lives logs; its methods wait for nobody, so end the server first.
class CapturedLog {
 public:
  CapturedLog() : before_(spdlog::default_logger()) {
    auto sink = std::make_shared<spdlog::sinks::ostream_sink_mt>(stream_);
    auto logger = std::make_shared<spdlog::logger>("test", sink);
    logger->set_level(spdlog::level::debug);
    spdlog::set_default_logger(logger);
  }
  ~CapturedLog() { spdlog::set_default_logger(before_); }
  CapturedLog(const CapturedLog&) = delete;
  CapturedLog& operator=(const CapturedLog&) = delete;

  std::string text() const { return stream_.str(); }

 private:
  std::shared_ptr<spdlog::logger> before_;
  std::ostringstream stream_;
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

std::string trailing_request_id(const grpc::ClientContext& context) {
  const auto& metadata = context.GetServerTrailingMetadata();
  const auto id = metadata.find(kRequestIdKey);
  return id == metadata.end() ? "" : std::string(id->second.data(), id->second.size());
}

TEST(CallObserver, WritesOneLineACallWithTheCallersName) {
  const CapturedLog log;
  std::string id;
  {
    const TestServer server;
    grpc::ClientContext named;
    named.AddMetadata(kRequestIdKey, "cell-4/job-7");
    wire::PlanMotionResponse response;
    ASSERT_TRUE(server.stub()->PlanMotion(&named, paper_request(), &response).ok());
    EXPECT_EQ(trailing_request_id(named), "cell-4/job-7");
    grpc::ClientContext verify;
    wire::VerifyMotionResponse verified;
    ASSERT_TRUE(server.stub()->VerifyMotion(&verify, paper_verify_request(), &verified).ok());
    id = trailing_request_id(verify);
    EXPECT_EQ(id.size(), 16u);
  }
  EXPECT_THAT(log.text(), HasSubstr("VerifyMotion OK request_id=" + id + " total_ms="));
  EXPECT_EQ(count(log.text(), "PlanMotion OK request_id=cell-4/job-7 total_ms="), 1u) << log.text();
  EXPECT_THAT(log.text(), HasSubstr("outcome=undecided"));
  EXPECT_THAT(log.text(), HasSubstr("outcome=holds"));
}

TEST(CallObserver, ReplacesANameThatWouldForgeTheLog) {
  const CapturedLog log;
  grpc::ClientContext context;
  {
    const TestServer server;
    context.AddMetadata(kRequestIdKey, "forged caller=root");
    wire::PlanMotionResponse response;
    ASSERT_TRUE(server.stub()->PlanMotion(&context, paper_request(), &response).ok());
  }
  EXPECT_THAT(log.text(), Not(HasSubstr("forged")));
  EXPECT_THAT(log.text(), HasSubstr("request_id=" + trailing_request_id(context)));
}

TEST(CallObserver, SaysWhyACallFailed) {
  const CapturedLog log;
  {
    const TestServer server(functions_with_a_bug());
    wire::PlanMotionResponse response;
    grpc::ClientContext bad;
    EXPECT_FALSE(server.stub()->PlanMotion(&bad, {}, &response).ok());
    EXPECT_EQ(trailing_request_id(bad).size(), 16u);
    grpc::ClientContext bug;
    EXPECT_FALSE(server.stub()->PlanMotion(&bug, paper_request(), &response).ok());
  }
  EXPECT_THAT(log.text(), HasSubstr("PlanMotion INVALID_ARGUMENT request_id="));
  EXPECT_THAT(log.text(), HasSubstr("reason=INVALID_REQUEST violation_count="));
  EXPECT_THAT(log.text(), HasSubstr("PlanMotion INTERNAL request_id="));
  EXPECT_THAT(log.text(), HasSubstr("reason=BUG id="));
}

TEST(CallObserver, CountsCallsAndAnswers) {
  TestServer server;
  wire::PlanMotionResponse response;
  grpc::ClientContext good, bad;
  ASSERT_TRUE(server.stub()->PlanMotion(&good, paper_request(), &response).ok());
  EXPECT_FALSE(server.stub()->PlanMotion(&bad, {}, &response).ok());
  EXPECT_EQ(health_of(server.channel(), ""), 1);
  const std::string text = server.server().metrics().text();
  const std::string labels = "grpc_method=\"PlanMotion\",grpc_service=\"dualarm.planning.v1.PlanningService\"} 1";
  EXPECT_THAT(text, HasSubstr("{grpc_code=\"OK\"," + labels));
  EXPECT_THAT(text, HasSubstr("{grpc_code=\"INVALID_ARGUMENT\"," + labels));
  EXPECT_THAT(text, HasSubstr("dualarm_answers_total{outcome=\"undecided\"} 1"));
  EXPECT_THAT(text, HasSubstr("dualarm_phase_seconds_count{phase=\"rest\"} 1"));
  EXPECT_THAT(text, HasSubstr("{grpc_code=\"OK\",grpc_method=\"Check\",grpc_service=\"grpc.health.v1.Health\"} 1"));
  EXPECT_THAT(text, HasSubstr("dualarm_build_info{compiler=\"gcc "));
}

}  // namespace
}  // namespace dualarm
