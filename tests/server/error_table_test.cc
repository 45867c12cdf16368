// Every row of the table of errors in docs/api.md, provoked.
#include <gmock/gmock.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/generic/generic_stub.h>

#include <functional>
#include <future>
#include <regex>
#include <sstream>
#include <thread>

#include "server/calls/request_ids.h"
#include "server/logging/call_log.h"
#include "tests/server/error_detail.h"
#include "tests/server/paper_request.h"
#include "tests/server/test_server.h"
#include "tests/support/test_certificates.h"

namespace dualarm {
namespace {

using ::testing::HasSubstr;
using Code = grpc::StatusCode;

constexpr char kToken[] = "aaaaaaaaaaaaaaaa";

grpc::Status plan_motion(const TestServer& server, const wire::PlanMotionRequest& request = paper_request(),
                         const std::string& token = "") {
  grpc::ClientContext context;
  if (!token.empty()) context.AddMetadata("authorization", "Bearer " + token);
  wire::PlanMotionResponse response;
  return server.stub()->PlanMotion(&context, request, &response);
}

/// A server on which one plan runs until this ends.
class BusyServer {
 public:
  BusyServer(const ServerOptions& options, bool searches, const std::string& token = "")
      : server_(functions_with(searches ? search_planning(endless()) : quick_planning(endless())), options) {
    if (!token.empty()) context_.AddMetadata("authorization", "Bearer " + token);
    call_ = std::async(std::launch::async, [this] {
      wire::PlanMotionResponse response;
      return server_.stub()->PlanMotion(&context_, paper_request(), &response);
    });
    begun_.get_future().wait();
  }
  ~BusyServer() {
    context_.TryCancel();
    if (call_.valid()) call_.wait();
  }

  TestServer& server() { return server_; }
  grpc::ClientContext& context() { return context_; }
  grpc::Status end() { return call_.get(); }

 private:
  FakePlanning endless() {
    return [this](const Problem&, const Budget& budget, const Observer&) {
      begun_.set_value();
      while (!budget.exhausted()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      return undecided("");
    };
  }

  std::promise<void> begun_;
  TestServer server_;
  grpc::ClientContext context_;
  std::future<grpc::Status> call_;
};

ServerOptions without_queues() {
  ServerOptions options = patient_options();
  options.queue_capacity = 0;
  options.search_queue = 0;
  return options;
}

grpc::Status invalid_request() {
  wire::PlanMotionRequest request = paper_request();
  request.mutable_robot()->mutable_arms(1)->mutable_torque_limit()->mutable_constant()->set_max_newton_meters(-1e13);
  request.mutable_options()->set_clearance_m(-1.0);
  return plan_motion(TestServer(), request);
}

grpc::Status no_message() {
  const TestServer server;
  const grpc::Slice slice("\xff\xff\xff");
  const grpc::ByteBuffer request(&slice, 1);
  grpc::ByteBuffer response;
  grpc::ClientContext context;
  std::promise<grpc::Status> done;
  grpc::GenericStub(server.channel())
      .UnaryCall(&context, "/dualarm.planning.v1.PlanningService/PlanMotion", {}, &request, &response,
                 [&done](grpc::Status status) { done.set_value(std::move(status)); });
  return done.get_future().get();
}

grpc::Status full_queue() {
  BusyServer busy(without_queues(), false);
  return plan_motion(busy.server());
}

/// The quick worker that has just handed the first request to the search may not be back yet: asked again then.
grpc::Status full_search_queue() {
  BusyServer busy(without_queues(), true);
  constexpr int kMostTries = 200;
  grpc::Status status;
  for (int i = 0; i < kMostTries; ++i) {
    status = plan_motion(busy.server());
    if (detail_of<google::rpc::ErrorInfo>(status).reason() != "QUEUE_FULL") break;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return status;
}

grpc::Status too_many_streams() {
  ServerOptions options;
  options.max_streams = 1;
  const TestServer server(quick_functions(), options);
  const auto stub = server.stub();
  grpc::ClientContext first, second;
  const auto open = stub->PlanMotionBatch(&first);
  wire::PlanMotionBatchRequest request;
  wire::PlanMotionBatchResponse answer;
  open->Write(request);
  open->Read(&answer);  // so that the first is there before the second
  const grpc::Status status = stub->PlanMotionBatch(&second)->Finish();
  first.TryCancel();
  open->Finish();
  return status;
}

// As its error comes: a million requests would take the test a minute.
grpc::Status too_long_a_batch() {
  RequestIds ids;
  for (std::size_t i = 0; i < RequestIds::kMost; ++i) {
    if (const auto complaint = ids.complaint_about(std::to_string(i))) return complaint->status;
  }
  return ids.complaint_about("one more").value_or(Answer{}).status;
}

grpc::Status too_large_a_message() {
  ServerOptions options;
  options.max_message_mib = 1;
  wire::PlanMotionRequest request = paper_request();
  request.mutable_scene()->add_objects()->set_name(std::string(2 << 20, 'x'));
  return plan_motion(TestServer(quick_functions(), options), request);
}

ServerOptions with_tokens(const TemporaryFolder& folder) {
  ServerOptions options = patient_options();
  options.token_file = (folder.path() / "tokens").string();
  write_file(options.token_file, std::string("cell-4 ") + kToken + " 1\n");
  return options;
}

grpc::Status token(const std::string& sent) {
  const TemporaryFolder folder;
  return plan_motion(TestServer(quick_functions(), with_tokens(folder)), paper_request(), sent);
}

grpc::Status too_many_calls() {
  const TemporaryFolder folder;
  BusyServer busy(with_tokens(folder), false, kToken);
  return plan_motion(busy.server(), paper_request(), kToken);
}

grpc::Status past_the_deadline() {
  const TestServer server(functions_with(quick_planning([](const auto&...) {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    return undecided("");
  })));
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + std::chrono::milliseconds(50));
  wire::PlanMotionResponse response;
  return server.stub()->PlanMotion(&context, paper_request(), &response);
}

grpc::Status cancelled_by_the_caller() {
  BusyServer busy(patient_options(), false);
  busy.context().TryCancel();
  return busy.end();
}

grpc::Status out_of_time() {
  PlanningFunctions functions = quick_functions();
  functions.forbidden_region = [](const auto&...) { return std::nullopt; };
  const TestServer server(functions);
  wire::GetForbiddenRegionRequest request;
  *request.mutable_robot() = paper_request().robot();
  wire::GetForbiddenRegionResponse response;
  grpc::ClientContext context;
  return server.stub()->GetForbiddenRegion(&context, request, &response);
}

grpc::Status draining() {
  ServerOptions options = patient_options();
  options.worker_threads = 2;
  BusyServer busy(options, false);
  const auto stub = busy.server().stub();  // connected before
  wire::PlanMotionRequest check = paper_request();
  check.mutable_options()->set_validate_only(true);
  grpc::ClientContext before;
  wire::PlanMotionResponse response;
  stub->PlanMotion(&before, check, &response);
  std::future<void> drained =
      std::async(std::launch::async, [&] { busy.server().server().drain(std::chrono::seconds(60)); });
  grpc::Status status;
  while (status.ok()) {
    grpc::ClientContext context;
    status = stub->PlanMotion(&context, check, &response);
  }
  busy.context().TryCancel();
  drained.wait();
  return status;
}

grpc::Status gone() {
  const TemporaryFolder folder;
  const auto channel =
      grpc::CreateChannel("unix:" + (folder.path() / "nobody").string(), grpc::InsecureChannelCredentials());
  grpc::ClientContext context;
  wire::PlanMotionResponse response;
  return wire::PlanningService::NewStub(channel)->PlanMotion(&context, paper_request(), &response);
}

grpc::Status bug() { return plan_motion(TestServer(functions_with_a_bug())); }

struct Provoked {
  const char* name;
  Code code;
  std::string reason;  // of the ErrorInfo; "" where gRPC itself answers
  std::function<grpc::Status()> provoke;
  std::chrono::milliseconds retry_delay{0};
};

const std::vector<Provoked>& provoked() {
  using std::chrono::milliseconds;
  static const std::vector<Provoked> kAll = {
      {"Invalid", Code::INVALID_ARGUMENT, "INVALID_REQUEST", invalid_request},
      {"NoMessage", Code::INVALID_ARGUMENT, "MALFORMED_REQUEST", no_message},
      {"FullQueue", Code::RESOURCE_EXHAUSTED, "QUEUE_FULL", full_queue, milliseconds(100)},
      {"FullSearchQueue", Code::RESOURCE_EXHAUSTED, "SEARCH_QUEUE_FULL", full_search_queue, milliseconds(1000)},
      {"TooManyStreams", Code::RESOURCE_EXHAUSTED, "TOO_MANY_STREAMS", too_many_streams, milliseconds(1000)},
      {"TooLongABatch", Code::RESOURCE_EXHAUSTED, "BATCH_TOO_LONG", too_long_a_batch},
      {"TooLargeAMessage", Code::RESOURCE_EXHAUSTED, "", too_large_a_message},
      {"NoToken", Code::UNAUTHENTICATED, "TOKEN_MISSING", [] { return token(""); }},
      {"WrongToken", Code::UNAUTHENTICATED, "TOKEN_UNKNOWN", [] { return token("bbbbbbbbbbbbbbbb"); }},
      {"TooManyCalls", Code::RESOURCE_EXHAUSTED, "TOO_MANY_CALLS", too_many_calls, milliseconds(100)},
      {"Deadline", Code::DEADLINE_EXCEEDED, "", past_the_deadline},
      {"Cancelled", Code::CANCELLED, "", cancelled_by_the_caller},
      {"OutOfTime", Code::DEADLINE_EXCEEDED, "OUT_OF_TIME", out_of_time},
      {"Draining", Code::UNAVAILABLE, "DRAINING", draining},
      {"Gone", Code::UNAVAILABLE, "", gone},
      {"Bug", Code::INTERNAL, "BUG", bug},
  };
  return kAll;
}

class Error : public ::testing::TestWithParam<Provoked> {};

TEST_P(Error, HasItsCodeAndDetails) {
  const grpc::Status status = GetParam().provoke();
  EXPECT_EQ(status.error_code(), GetParam().code) << status.error_message();
  EXPECT_NE(status.error_message(), "");
  const auto info = detail_of<google::rpc::ErrorInfo>(status);
  EXPECT_EQ(info.reason(), GetParam().reason);
  EXPECT_EQ(info.domain(), GetParam().reason.empty() ? "" : "dualarm");
  const auto delay = detail_of<google::rpc::RetryInfo>(status).retry_delay();
  EXPECT_EQ(std::chrono::seconds(delay.seconds()) + std::chrono::nanoseconds(delay.nanos()), GetParam().retry_delay);
}

INSTANTIATE_TEST_SUITE_P(All, Error, ::testing::ValuesIn(provoked()),
                         [](const auto& error) { return std::string(error.param.name); });

TEST(ErrorDetails, NameEveryViolationByItsField) {
  const grpc::Status status = invalid_request();
  const auto request = detail_of<google::rpc::BadRequest>(status);
  std::vector<std::string> fields;
  for (const auto& violation : request.field_violations()) {
    fields.push_back(violation.field());
    EXPECT_NE(violation.description(), "") << violation.field();
    EXPECT_THAT(status.error_message(), HasSubstr(violation.field()));
  }
  constexpr char kTorque[] = "robot.arms[1].torque_limit.constant.max_newton_meters";
  EXPECT_THAT(fields, ::testing::ElementsAre(kTorque, kTorque, "options.clearance_m"));  // out of range, below min
  EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(status).metadata().at("violation_count"), "3");
}

TEST(ErrorDetails, OfABugHoldTheIdThatTheMessageNames) {
  const grpc::Status status = bug();
  const std::string id = detail_of<google::rpc::ErrorInfo>(status).metadata().at("id");
  EXPECT_EQ(id.size(), 16u);
  EXPECT_THAT(status.error_message(), HasSubstr(id));
}

bool is_provoked(std::string_view code, std::string_view reason) {
  return std::any_of(provoked().begin(), provoked().end(),
                     [&](const Provoked& error) { return code_name(error.code) == code && error.reason == reason; });
}

// Words in capitals: codes of the first column, reasons of the third.
std::vector<std::string> capitals(const std::string& cell) {
  static const std::regex kWord("[A-Za-z_]+");
  std::vector<std::string> words;
  for (std::sregex_iterator word(cell.begin(), cell.end(), kWord), end; word != end; ++word) {
    const std::string text = word->str();
    const bool has_small = std::any_of(text.begin(), text.end(), [](char c) { return c >= 'a' && c <= 'z'; });
    if (!has_small) words.push_back(text);
  }
  return words;
}

TEST(ErrorTable, OfTheDocumentIsProvokedRowByRow) {
  std::istringstream document(content_of(DUALARM_SOURCE_DIR "/docs/api.md"));
  std::string line;
  while (std::getline(document, line) && line != "## Errors") continue;
  int rows = 0;
  while (std::getline(document, line) && !line.starts_with("## ")) {
    if (!line.starts_with("| ") || line.starts_with("| code")) continue;
    ++rows;
    std::istringstream cells(line.substr(1));
    std::string codes, when, details;
    std::getline(cells, codes, '|') && std::getline(cells, when, '|') && std::getline(cells, details, '|');
    std::vector<std::string> reasons = capitals(details);
    if (reasons.empty()) reasons.emplace_back();
    for (const std::string& code : capitals(codes)) {
      for (const std::string& reason : reasons) {
        EXPECT_TRUE(is_provoked(code, reason)) << "no test for " << code << " " << reason << ": " << line;
      }
    }
  }
  EXPECT_GE(rows, 12);
}

}  // namespace
}  // namespace dualarm
