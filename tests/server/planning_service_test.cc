#include "server/planning_service.h"

#include <gmock/gmock.h>

#include <atomic>
#include <future>
#include <thread>

#include "google/rpc/error_details.pb.h"
#include "tests/server/error_detail.h"
#include "tests/server/paper_request.h"
#include "tests/server/test_server.h"

namespace dualarm {
namespace {

using ::testing::HasSubstr;
using Code = grpc::StatusCode;

grpc::Status plan_motion(const TestServer& server, const wire::PlanMotionRequest& request,
                         wire::PlanMotionResponse* response = nullptr) {
  grpc::ClientContext context;
  wire::PlanMotionResponse unused;
  return server.stub()->PlanMotion(&context, request, response == nullptr ? &unused : response);
}

TEST(PlanningService, AnswersWhatThePlannerAnswers) {
  const TestServer server;
  wire::PlanMotionResponse response;
  ASSERT_TRUE(plan_motion(server, paper_request(), &response).ok());
  EXPECT_EQ(response.undecided().explanation(), "quick");
  EXPECT_EQ(response.undecided().tried(0), "nothing");
}

TEST(PlanningService, ListsAllViolationsInMessageAndDetails) {
  const TestServer server;
  wire::PlanMotionRequest request = paper_request();
  request.mutable_robot()->mutable_arms(1)->mutable_torque_limit()->mutable_constant()->set_max_newton_meters(-90.0);
  request.mutable_tasks(0)->clear_goal();
  const grpc::Status status = plan_motion(server, request);
  EXPECT_EQ(status.error_code(), Code::INVALID_ARGUMENT);
  EXPECT_THAT(status.error_message(), HasSubstr("2 violations: "));
  EXPECT_THAT(status.error_message(), HasSubstr("robot.arms[1].torque_limit.constant.max_newton_meters is -90"));
  const auto bad_request = detail_of<google::rpc::BadRequest>(status);
  ASSERT_EQ(bad_request.field_violations_size(), 2);
  EXPECT_EQ(bad_request.field_violations(0).field(), "robot.arms[1].torque_limit.constant.max_newton_meters");
  EXPECT_EQ(bad_request.field_violations(1).field(), "tasks[0].goal");
  const auto info = detail_of<google::rpc::ErrorInfo>(status);
  EXPECT_EQ(info.domain(), "dualarm");
  EXPECT_EQ(info.reason(), "INVALID_REQUEST");
  EXPECT_EQ(info.metadata().at("violation_count"), "2");
}

// A client with gRPC's default limits takes 8 KiB of metadata; more would replace our answer by an error of gRPC's.
TEST(PlanningService, AThousandViolationsStillFitIntoTheAnswer) {
  const TestServer server;
  wire::PlanMotionRequest request = paper_request();
  for (int i = 0; i < 1000; ++i) request.mutable_scene()->add_objects()->set_name(std::string(64, '%'));
  const grpc::Status status = plan_motion(server, request);
  EXPECT_EQ(status.error_code(), Code::INVALID_ARGUMENT) << status.error_message();
  EXPECT_THAT(status.error_message(), HasSubstr("more"));
  EXPECT_GE(detail_of<google::rpc::BadRequest>(status).field_violations_size(), 20);
  EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(status).metadata().at("violation_count"), "2999");
}

TEST(PlanningService, ValidateOnlyPlansNothing) {
  std::atomic<int> planned = 0;
  const TestServer server(functions_with(quick_planning([&planned](const auto&...) {
    ++planned;
    return undecided("");
  })));
  wire::PlanMotionRequest request = paper_request();
  request.mutable_options()->set_validate_only(true);
  wire::PlanMotionResponse response;
  ASSERT_TRUE(plan_motion(server, request, &response).ok());
  EXPECT_EQ(response.outcome_case(), wire::PlanMotionResponse::OUTCOME_NOT_SET);
  EXPECT_EQ(planned, 0);
  request.clear_tasks();
  EXPECT_EQ(plan_motion(server, request).error_code(), Code::INVALID_ARGUMENT);
}

TEST(PlanningService, PassesTheTrajectoriesOnToTheVerifier) {
  PlanningFunctions functions = quick_functions();
  functions.verify = [](const Problem& problem, const Trajectory& trajectory, const Budget&, bool check_end_states) {
    Verification verification;
    verification.violations.push_back({ViolationKind::kTorque, problem.arms[1].name, trajectory[1].arm, 0.5,
                                       trajectory[1].knots[1].position, check_end_states ? 1.0 : 0.0});
    return verification;
  };
  const TestServer server(functions);
  grpc::ClientContext context;
  wire::VerifyMotionResponse response;
  ASSERT_TRUE(server.stub()->VerifyMotion(&context, paper_verify_request(), &response).ok());
  ASSERT_EQ(response.verification().violations_size(), 1);
  const wire::Violation& violation = response.verification().violations(0);
  EXPECT_EQ(violation.kind(), wire::VIOLATION_KIND_TORQUE);
  EXPECT_EQ(violation.explanation(), "right");
  EXPECT_EQ(violation.arm(), "right");
  EXPECT_EQ(violation.time_s(), 0.5);
  EXPECT_EQ(violation.value(), 2.0);
  EXPECT_EQ(violation.limit(), 0.0);
}

TEST(PlanningService, DrawsTheForbiddenRegion) {
  const TestServer server;
  wire::GetForbiddenRegionRequest request;
  *request.mutable_robot() = paper_request().robot();
  grpc::ClientContext context;
  wire::GetForbiddenRegionResponse response;
  ASSERT_TRUE(server.stub()->GetForbiddenRegion(&context, request, &response).ok());
  ASSERT_EQ(response.contours_size(), 1);
  EXPECT_EQ(response.contours(0).theta1_rad(1), 1.0);
  EXPECT_EQ(response.contours(0).theta2_rad(2), 1.0);
  EXPECT_EQ(response.theta2_range().max_rad(), paper_request().robot().arms(1).base().heading_rad());
}

TEST(PlanningService, TheForbiddenRegionEndsWithTheServersCap) {
  PlanningFunctions functions = quick_functions();
  functions.forbidden_region = [](const Problem&, int, const Budget& budget) -> std::optional<std::vector<Contour>> {
    while (!budget.exhausted()) std::this_thread::yield();
    return std::nullopt;
  };
  ServerOptions options = patient_options();
  options.planning_budget = 0.05;
  const TestServer server(functions, options);
  wire::GetForbiddenRegionRequest request;
  *request.mutable_robot() = paper_request().robot();
  grpc::ClientContext context;
  wire::GetForbiddenRegionResponse response;
  const grpc::Status status = server.stub()->GetForbiddenRegion(&context, request, &response);
  EXPECT_EQ(status.error_code(), Code::DEADLINE_EXCEEDED);
  EXPECT_THAT(status.error_message(), HasSubstr("a lower resolution or fewer objects"));
  EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(status).reason(), "OUT_OF_TIME");
}

TEST(PlanningService, ACallerWhoCancelsStopsTheForbiddenRegion) {
  std::promise<void> begun;
  std::promise<bool> cancelled;
  PlanningFunctions functions = quick_functions();
  functions.forbidden_region = [&](const Problem&, int, const Budget& budget) {
    begun.set_value();
    while (!budget.exhausted()) std::this_thread::yield();
    cancelled.set_value(budget.cancelled());
    return std::optional<std::vector<Contour>>();
  };
  const TestServer server(functions, patient_options());
  wire::GetForbiddenRegionRequest request;
  *request.mutable_robot() = paper_request().robot();
  grpc::ClientContext context;
  std::future<grpc::Status> status = std::async(std::launch::async, [&] {
    wire::GetForbiddenRegionResponse response;
    return server.stub()->GetForbiddenRegion(&context, request, &response);
  });
  begun.get_future().wait();
  context.TryCancel();
  EXPECT_EQ(status.get().error_code(), Code::CANCELLED);
  EXPECT_TRUE(cancelled.get_future().get());
}

TEST(PlanningService, ABugIsInternalWithAnIdAndTheServerGoesOn) {
  std::atomic<int> calls = 0;
  const TestServer server(functions_with(quick_planning([&calls](const auto&...) {
    if (++calls == 1) throw std::logic_error("secret of the house");
    if (calls == 2) throw 42;
    return undecided("");
  })));
  for (int i = 0; i < 2; ++i) {
    const grpc::Status status = plan_motion(server, paper_request());
    EXPECT_EQ(status.error_code(), Code::INTERNAL);
    EXPECT_THAT(status.error_message(), Not(HasSubstr("secret")));
    const auto info = detail_of<google::rpc::ErrorInfo>(status);
    EXPECT_EQ(info.reason(), "BUG");
    EXPECT_EQ(info.metadata().at("id").size(), 16u);
    EXPECT_THAT(status.error_message(), HasSubstr(info.metadata().at("id")));
  }
  EXPECT_TRUE(plan_motion(server, paper_request()).ok());
}

// Plans until its budget is exhausted, and tells that it began and that it ended: of its run after a worker's trial, or
// of the first one if that was not cut short.
struct EndlessPlanning {
  std::promise<void> begun;
  std::promise<bool> cancelled;
  std::atomic<int> runs = 0;

  PlanningFunctions functions() {
    return functions_with(quick_planning([this](const Problem&, const Budget& budget, const Observer&) {
      const int run = ++runs;
      if (run == 2) begun.set_value();
      while (!budget.exhausted()) std::this_thread::yield();
      if (run == 2 || !budget.cancelled()) cancelled.set_value(budget.cancelled());
      return undecided("budget spent");
    }));
  }
};

TEST(PlanningService, ACallerWhoCancelsStopsTheWork) {
  EndlessPlanning planning;
  const TestServer server(planning.functions(), patient_options());
  grpc::ClientContext context;
  std::future<grpc::Status> status = std::async(std::launch::async, [&] {
    wire::PlanMotionResponse response;
    return server.stub()->PlanMotion(&context, paper_request(), &response);
  });
  planning.begun.get_future().wait();
  context.TryCancel();
  EXPECT_EQ(status.get().error_code(), Code::CANCELLED);
  EXPECT_TRUE(planning.cancelled.get_future().get());
}

TEST(PlanningService, TheDeadlineOfTheCallerLeavesTimeToAnswer) {
  EndlessPlanning planning;
  const TestServer server(planning.functions(), patient_options());
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + std::chrono::milliseconds(500));
  wire::PlanMotionResponse response;
  const grpc::Status status = server.stub()->PlanMotion(&context, paper_request(), &response);
  EXPECT_FALSE(planning.cancelled.get_future().get());
  // The answer is sent before the deadline; on a machine under load it may still come too late.
  EXPECT_TRUE(status.ok() || status.error_code() == Code::DEADLINE_EXCEEDED) << status.error_message();
}

TEST(PlanningService, PlanningEndsWithItsBudgetAndWithTheServersCap) {
  for (const bool by_request : {true, false}) {
    EndlessPlanning planning;
    ServerOptions options = patient_options();
    if (!by_request) options.planning_budget = 0.05;
    const TestServer server(planning.functions(), options);
    wire::PlanMotionRequest request = paper_request();
    auto& budget = *request.mutable_options()->mutable_planning_budget();
    by_request ? budget.set_nanos(50'000'000) : budget.set_seconds(30);
    wire::PlanMotionResponse response;
    ASSERT_TRUE(plan_motion(server, request, &response).ok());
    EXPECT_EQ(response.undecided().explanation(), "budget spent");
    EXPECT_FALSE(planning.cancelled.get_future().get());
  }
}

TEST(PlanningService, AFullQueueIsRefusedWithARetryDelayWhileHealthAnswers) {
  EndlessPlanning planning;
  ServerOptions options = patient_options();
  options.worker_threads = 1;
  options.queue_capacity = 0;
  const TestServer server(planning.functions(), options);
  grpc::ClientContext context;
  std::future<grpc::Status> running = std::async(std::launch::async, [&] {
    wire::PlanMotionResponse response;
    return server.stub()->PlanMotion(&context, paper_request(), &response);
  });
  planning.begun.get_future().wait();
  const grpc::Status refused = plan_motion(server, paper_request());
  EXPECT_EQ(refused.error_code(), Code::RESOURCE_EXHAUSTED);
  EXPECT_THAT(refused.error_message(), HasSubstr("try again"));
  EXPECT_GT(detail_of<google::rpc::RetryInfo>(refused).retry_delay().nanos(), 0);
  EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(refused).reason(), "QUEUE_FULL");
  EXPECT_EQ(health_of(server.channel(), "dualarm.planning.v1.PlanningService"), 1);
  context.TryCancel();
  running.wait();
}

}  // namespace
}  // namespace dualarm
