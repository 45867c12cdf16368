// Two servers, one of which goes while both are busy: a client with docs/service_config.json loses no request.
#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <regex>
#include <thread>
#include <vector>

#include "tests/server/paper_request.h"
#include "tests/server/server_process.h"
#include "tests/support/test_certificates.h"

namespace dualarm {
namespace {

constexpr int kCallers = 8;
constexpr int kCallsOfEach = 250;
constexpr int kCallsBeforeTheEnd = kCallers * kCallsOfEach / 4;

std::shared_ptr<grpc::Channel> channel_to(const std::string& first, const std::string& second,
                                          const std::string& service_config = content_of(DUALARM_SERVICE_CONFIG)) {
  grpc::ChannelArguments arguments;
  arguments.SetServiceConfigJSON(service_config);
  return grpc::CreateCustomChannel("ipv4:" + first + "," + second, grpc::InsecureChannelCredentials(), arguments);
}

class Failover : public ::testing::TestWithParam<int> {};

TEST_P(Failover, LosesNoRequestWhenOneOfTwoServersGoes) {
  std::array<ServerProcess, 2> servers;
  const std::string first = servers[0].wait_for_address();
  const std::string second = servers[1].wait_for_address();
  ASSERT_NE(first, "") << servers[0].log();
  ASSERT_NE(second, "") << servers[1].log();
  const auto stub = wire::PlanningService::NewStub(channel_to(first, second));
  std::atomic<int> answered = 0;
  std::mutex mutex;
  std::vector<std::string> lost;
  std::vector<std::jthread> callers;
  for (int i = 0; i < kCallers; ++i) {
    callers.emplace_back([&] {
      for (int j = 0; j < kCallsOfEach; ++j) {
        grpc::ClientContext context;
        context.set_deadline(std::chrono::system_clock::now() + std::chrono::seconds(60));
        wire::PlanMotionResponse response;
        const grpc::Status status = stub->PlanMotion(&context, paper_request(), &response);
        ++answered;
        if (status.ok() && response.has_plan()) continue;
        const std::lock_guard lock(mutex);
        lost.push_back(std::to_string(status.error_code()) + " " + status.error_message());
      }
    });
  }
  while (answered < kCallsBeforeTheEnd) std::this_thread::yield();
  const bool both_were_busy = servers[0].log().find("PlanMotion OK") != std::string::npos &&
                              servers[1].log().find("PlanMotion OK") != std::string::npos;
  servers[0].signal(GetParam());
  callers.clear();
  EXPECT_TRUE(both_were_busy);
  EXPECT_EQ(answered, kCallers * kCallsOfEach);
  EXPECT_TRUE(lost.empty()) << lost.size() << " of " << answered << " lost, the first: " << lost.front() << "\n"
                            << servers[0].log().substr(servers[0].log().find("draining"));
  EXPECT_EQ(servers[0].wait_for_exit(), GetParam() == SIGKILL ? -1 : 0);
}

INSTANTIATE_TEST_SUITE_P(Signals, Failover, ::testing::Values(SIGKILL, SIGTERM),
                         [](const auto& signal) { return signal.param == SIGKILL ? "Killed" : "Drained"; });

/// With two attempts a call instead of five: one in four would be lost while a server drains that is still asked.
std::string with_two_attempts() {
  return std::regex_replace(content_of(DUALARM_SERVICE_CONFIG), std::regex("\"maxAttempts\": 5"), "\"maxAttempts\": 2");
}

TEST(LongDrain, IsSpentByCallersOnTheOtherServer) {
  ServerProcess leaving({"--drain-seconds", "60"});
  ServerProcess staying;
  const std::string first = leaving.wait_for_address();
  const std::string second = staying.wait_for_address();
  ASSERT_NE(first, "") << leaving.log();
  ASSERT_NE(second, "") << staying.log();
  ASSERT_NE(with_two_attempts(), content_of(DUALARM_SERVICE_CONFIG));
  const auto stub = wire::PlanningService::NewStub(channel_to(first, second, with_two_attempts()));
  grpc::ClientContext warming;
  wire::PlanMotionResponse warm;
  ASSERT_TRUE(stub->PlanMotion(&warming, paper_request(), &warm).ok());

  const auto searching = wire::PlanningService::NewStub(grpc::CreateChannel(first, grpc::InsecureChannelCredentials()));
  wire::PlanMotionStreamRequest search;
  *search.mutable_request() = paper_request();
  search.mutable_request()->mutable_options()->add_methods(wire::METHOD_STATE_TIME);
  grpc::ClientContext context;
  const auto reader = searching->PlanMotionStream(&context, search);
  wire::PlanMotionStreamResponse event;
  ASSERT_TRUE(reader->Read(&event)) << leaving.log();
  leaving.signal(SIGTERM);

  std::atomic<bool> drains = true;
  int answered = 0;
  std::vector<std::string> lost;
  std::jthread caller([&] {
    while (drains) {
      grpc::ClientContext of_call;
      of_call.set_deadline(std::chrono::system_clock::now() + std::chrono::seconds(60));
      wire::PlanMotionResponse response;
      const grpc::Status status = stub->PlanMotion(&of_call, paper_request(), &response);
      status.ok() ? void(++answered) : lost.push_back(status.error_message());
    }
  });
  while (reader->Read(&event)) continue;
  EXPECT_TRUE(reader->Finish().ok());
  drains = false;
  caller.join();
  EXPECT_EQ(leaving.wait_for_exit(), 0);
  EXPECT_GT(answered, 20);
  EXPECT_TRUE(lost.empty()) << lost.size() << " beside " << answered << ", the first: " << lost.front();
}

}  // namespace
}  // namespace dualarm
