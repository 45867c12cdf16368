// The real binary: server/main.cc with the real planner behind it.
#include <gmock/gmock.h>
#include <google/protobuf/util/json_util.h>
#include <grpcpp/create_channel.h>
#include <signal.h>

#include <fstream>
#include <future>
#include <sstream>

#include "server/request/requests.h"
#include "tests/server/http_get.h"
#include "tests/server/paper_request.h"
#include "tests/server/server_process.h"

namespace dualarm {
namespace {

using ::testing::HasSubstr;

constexpr char kService[] = "dualarm.planning.v1.PlanningService";

std::shared_ptr<grpc::Channel> channel_to(const std::string& address) {
  return grpc::CreateChannel(address, grpc::InsecureChannelCredentials());
}

wire::PlanMotionRequest scenario(const std::filesystem::path& path) {
  std::ostringstream json;
  json << std::ifstream(path).rdbuf();
  wire::PlanMotionRequest request;
  const auto status = google::protobuf::util::JsonStringToMessage(json.str(), &request);
  EXPECT_TRUE(status.ok()) << path << ": " << status.ToString();
  return request;
}

TEST(Server, PlansThePapersCaseAndVerifiesWhatItSent) {
  ServerProcess process;
  const std::string address = process.wait_for_address();
  ASSERT_NE(address, "") << process.log();
  const auto stub = wire::PlanningService::NewStub(channel_to(address));
  grpc::ClientContext context;
  wire::PlanMotionResponse response;
  const grpc::Status status = stub->PlanMotion(&context, paper_request(), &response);
  ASSERT_TRUE(status.ok()) << status.error_message();
  ASSERT_TRUE(response.has_plan()) << response.ShortDebugString();
  const wire::Plan& plan = response.plan();
  EXPECT_EQ(plan.method(), wire::METHOD_PASSAGE);
  EXPECT_NEAR(plan.duration_s(), 1.79374, 2e-4);  // theory, section 4; the best delay takes 1.795627
  EXPECT_EQ(plan.certificate().claim(), wire::CLAIM_OPTIMAL);
  EXPECT_TRUE(plan.verification().collision_free());
  EXPECT_EQ(plan.verification().violations_size(), 0);

  wire::VerifyMotionRequest sent;
  *sent.mutable_robot() = paper_request().robot();
  *sent.mutable_tasks() = paper_request().tasks();
  *sent.mutable_trajectories() = plan.trajectories();
  grpc::ClientContext verify_context;
  wire::VerifyMotionResponse verified;
  ASSERT_TRUE(stub->VerifyMotion(&verify_context, sent, &verified).ok());
  EXPECT_TRUE(verified.verification().collision_free()) << verified.ShortDebugString();
  EXPECT_EQ(verified.verification().violations_size(), 0) << verified.ShortDebugString();

  // The same motion asked to keep a metre: refuted by the same code.
  sent.set_clearance_m(1.0);
  grpc::ClientContext refute_context;
  ASSERT_TRUE(stub->VerifyMotion(&refute_context, sent, &verified).ok());
  EXPECT_FALSE(verified.verification().collision_free());
}

TEST(Server, DrawsThePapersForbiddenRegion) {
  ServerProcess process;
  const std::string address = process.wait_for_address();
  const auto stub = wire::PlanningService::NewStub(channel_to(address));
  wire::GetForbiddenRegionRequest request;
  *request.mutable_robot() = paper_request().robot();
  grpc::ClientContext context;
  wire::GetForbiddenRegionResponse response;
  const grpc::Status status = stub->GetForbiddenRegion(&context, request, &response);
  ASSERT_TRUE(status.ok()) << status.error_message();
  ASSERT_EQ(response.contours_size(), 1);
  double tip = 0.0;  // the lens ends where both tips meet: theta = acos(2/3) each (theory, section 2)
  for (int i = 0; i < response.contours(0).theta1_rad_size(); ++i) {
    tip = std::max(tip, std::min(response.contours(0).theta1_rad(i), response.contours(0).theta2_rad(i)));
  }
  EXPECT_NEAR(tip, std::acos(2.0 / 3.0), 0.02);
}

TEST(Server, StopsOnSigtermAndSigintWithStatusZero) {
  for (const int number : {SIGTERM, SIGINT}) {
    ServerProcess process;
    const std::string address = process.wait_for_address();
    ASSERT_NE(address, "") << process.log();
    EXPECT_EQ(health_of(channel_to(address), kService), 1);
    process.signal(number);
    EXPECT_EQ(process.wait_for_exit(), 0);
    EXPECT_THAT(process.log(), HasSubstr("listening on " + address));
    EXPECT_THAT(process.log(), HasSubstr("draining"));
    EXPECT_THAT(process.log(), HasSubstr("stopped"));
  }
}

TEST(Server, FinishesARunningSearchWhileItDrains) {
  ServerProcess process({"--drain-seconds", "120", "--metrics-listen", "0"});
  const std::string address = process.wait_for_address();
  const std::string metrics_address = process.wait_for_metrics_address();
  ASSERT_NE(address, "") << process.log();
  ASSERT_NE(metrics_address, "") << process.log();
  wire::PlanMotionRequest request = paper_request();
  request.mutable_options()->add_methods(wire::METHOD_STATE_TIME);
  request.mutable_options()->mutable_planning_budget()->set_seconds(2);
  const auto channel = channel_to(address);
  const auto stub = wire::PlanningService::NewStub(channel);
  grpc::ClientContext context;
  wire::PlanMotionResponse response;
  std::promise<grpc::Status> answer;
  std::future<grpc::Status> answered = answer.get_future();
  stub->async()->PlanMotion(&context, &request, &response,
                            [&answer](grpc::Status status) { answer.set_value(std::move(status)); });
  EXPECT_EQ(health_of(channel, kService), 1);  // on the same connection: the call before it has arrived
  const std::string in_flight = "dualarm_calls_in_flight{grpc_method=\"PlanMotion\",grpc_service=\"" +
                                std::string(kService) + "\"} 1";  // and has been taken up
  while (http_get(metrics_address, "/metrics").find(in_flight) == std::string::npos) {
    ASSERT_NE(answered.wait_for(std::chrono::milliseconds(5)), std::future_status::ready) << in_flight;
  }
  process.signal(SIGTERM);
  const grpc::Status status = answered.get();
  EXPECT_TRUE(status.ok()) << status.error_message();
  EXPECT_EQ(process.wait_for_exit(), 0);
  EXPECT_LT(process.log().find("draining"), process.log().find("PlanMotion OK")) << process.log();
}

TEST(Server, LogsRegionsThatTakeTooLong) {
  ServerProcess process({"--planning-budget", "0.001"});
  const std::string address = process.wait_for_address();
  ASSERT_NE(address, "") << process.log();
  const auto stub = wire::PlanningService::NewStub(channel_to(address));
  wire::GetForbiddenRegionRequest request;
  *request.mutable_robot() = paper_request().robot();
  request.set_resolution(2000);
  grpc::ClientContext context;
  wire::GetForbiddenRegionResponse region;
  EXPECT_EQ(stub->GetForbiddenRegion(&context, request, &region).error_code(), grpc::StatusCode::DEADLINE_EXCEEDED);
  process.signal(SIGTERM);  // the line comes after the answer
  EXPECT_EQ(process.wait_for_exit(), 0);
  EXPECT_THAT(process.log(), HasSubstr("GetForbiddenRegion DEADLINE_EXCEEDED"));
}

TEST(Server, RefusesAPortThatIsTaken) {
  ServerProcess first;
  const std::string address = first.wait_for_address();
  ASSERT_NE(address, "") << first.log();
  ServerProcess second({"--listen", address});
  EXPECT_EQ(second.wait_for_exit(), 1);
  EXPECT_THAT(second.log(), HasSubstr("cannot listen on " + address));
  EXPECT_EQ(health_of(channel_to(address), kService), 1);
}

TEST(Server, ExitsWithTwoOnWrongUsageAndTellsItsVersion) {
  ServerProcess wrong({"--no-such-flag"});
  EXPECT_EQ(wrong.wait_for_exit(), 2);
  ServerProcess nowhere({"--listen", "nonsense"});
  EXPECT_EQ(nowhere.wait_for_exit(), 2);
  EXPECT_THAT(nowhere.log(), HasSubstr("give HOST:PORT with a port of 0 to 65535"));
  ServerProcess version({"--version"});
  EXPECT_EQ(version.wait_for_exit(), 0);
  for (const char* part :
       {"dualarm-server " DUALARM_VERSION " (git ", "compiler gcc ", "grpc 1.", "fcl 0.", "ompl 1."}) {
    EXPECT_THAT(version.log(), HasSubstr(part));
  }
}

TEST(Scenarios, AreSoundRequestsInJson) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(DUALARM_SCENARIOS)) {
    if (entry.path().extension() != ".json") continue;
    SCOPED_TRACE(entry.path().string());
    ++count;
    const auto parsed = parse(scenario(entry.path()));
    const auto* violations = std::get_if<Violations>(&parsed);
    EXPECT_EQ(violations, nullptr) << violations->kept()[0].field << ' ' << violations->kept()[0].description;
  }
  EXPECT_GE(count, 7);
}

}  // namespace
}  // namespace dualarm
