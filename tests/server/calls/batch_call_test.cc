#include "server/calls/batch_call.h"

#include <gmock/gmock.h>
#include <grpcpp/generic/generic_stub.h>

#include <atomic>
#include <future>
#include <map>
#include <thread>

#include "tests/server/error_detail.h"
#include "tests/server/paper_request.h"
#include "tests/server/test_server.h"

namespace dualarm {
namespace {

using ::testing::HasSubstr;
using Code = grpc::StatusCode;
using Request = wire::PlanMotionBatchRequest;
using Response = wire::PlanMotionBatchResponse;
using Stream = grpc::ClientReaderWriter<Request, Response>;

// The seed tells the planner which request it is.
Request batch_request(const std::string& id, int seed = 0) {
  Request request;
  request.set_request_id(id);
  *request.mutable_request() = paper_request();
  request.mutable_request()->mutable_options()->set_seed(seed);
  return request;
}

Outcome echo(const Problem& problem, const Budget&, const Observer&) {
  return undecided(std::to_string(problem.options.seed));
}

/// Everything that comes until the end, by id; ids that come twice are an error.
std::map<std::string, Response> read_all(Stream& stream) {
  std::map<std::string, Response> answers;
  for (Response answer; stream.Read(&answer);) {
    EXPECT_TRUE(answers.emplace(answer.request_id(), answer).second) << answer.request_id();
  }
  return answers;
}

/// `requests` sent at once, and everything that is answered.
std::map<std::string, Response> answers_to(const TestServer& server, const std::vector<Request>& requests) {
  grpc::ClientContext context;
  const auto stream = server.stub()->PlanMotionBatch(&context);
  std::thread writer([&] {
    for (const Request& request : requests) stream->Write(request);
    stream->WritesDone();
  });
  auto answers = read_all(*stream);
  writer.join();
  const grpc::Status status = stream->Finish();
  EXPECT_TRUE(status.ok()) << status.error_message();
  return answers;
}

TEST(BatchCall, AnswersEveryRequestUnderItsId) {
  for (const auto& planning : {quick_planning(echo), search_planning(echo)}) {
    const TestServer server(functions_with(planning));
    std::vector<Request> requests;
    for (int i = 0; i < 2000; ++i) requests.push_back(batch_request("request " + std::to_string(i), i));
    const auto answers = answers_to(server, requests);
    ASSERT_EQ(answers.size(), requests.size());
    for (int i = 0; i < 2000; ++i) {
      const Response& answer = answers.at("request " + std::to_string(i));
      EXPECT_EQ(answer.response().undecided().explanation(), std::to_string(i)) << answer.ShortDebugString();
    }
  }
}

TEST(BatchCall, AnEmptyBatchEndsWell) {
  const TestServer server;
  EXPECT_TRUE(answers_to(server, {}).empty());
}

TEST(BatchCall, AnswersAsTheyFinish) {
  std::promise<void> release;
  ServerOptions options = patient_options();
  options.worker_threads = 2;
  const TestServer server(functions_with(quick_planning([&](const Problem& problem, const auto&...) {
                            if (problem.options.seed == 1) release.get_future().wait();
                            return undecided("");
                          })),
                          options);
  grpc::ClientContext context;
  const auto stream = server.stub()->PlanMotionBatch(&context);
  stream->Write(batch_request("slow", 1));
  stream->Write(batch_request("fast"));
  Response answer;
  ASSERT_TRUE(stream->Read(&answer));
  EXPECT_EQ(answer.request_id(), "fast");
  release.set_value();
  ASSERT_TRUE(stream->Read(&answer));
  EXPECT_EQ(answer.request_id(), "slow");
  stream->WritesDone();
  EXPECT_TRUE(stream->Finish().ok());
}

TEST(BatchCall, ABadRequestIsAnsweredByItsOwnErrorAndTheOthersGoOn) {
  const TestServer server(functions_with(quick_planning([](const Problem& problem, const auto&...) {
    if (problem.options.seed == 1) throw std::logic_error("secret of the house");
    return undecided("");
  })));
  Request bad = batch_request("bad");
  bad.mutable_request()->mutable_robot()->mutable_arms(0)->mutable_link()->set_length_m(-1.0);
  bad.mutable_request()->clear_tasks();
  Request empty;
  empty.set_request_id("empty");
  Request valid = batch_request("valid", 1);
  valid.mutable_request()->mutable_options()->set_validate_only(true);
  const auto answers = answers_to(server, {bad, empty, batch_request("bug", 1), valid, batch_request("good")});
  ASSERT_EQ(answers.size(), 5u);

  const google::rpc::Status& refused = answers.at("bad").error();
  EXPECT_EQ(refused.code(), Code::INVALID_ARGUMENT);
  EXPECT_THAT(refused.message(), HasSubstr("2 violations: robot.arms[0].link.length_m is -1"));
  const auto bad_request = detail_of<google::rpc::BadRequest>(refused);
  ASSERT_EQ(bad_request.field_violations_size(), 2);
  EXPECT_EQ(bad_request.field_violations(1).field(), "tasks");
  EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(refused).reason(), "INVALID_REQUEST");

  EXPECT_EQ(answers.at("empty").error().code(), Code::INVALID_ARGUMENT);
  EXPECT_EQ(answers.at("bug").error().code(), Code::INTERNAL);
  EXPECT_THAT(answers.at("bug").error().message(), Not(HasSubstr("secret")));
  EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(answers.at("bug").error()).metadata().at("id").size(), 16u);
  EXPECT_TRUE(answers.at("valid").has_response());
  EXPECT_EQ(answers.at("valid").response().outcome_case(), wire::PlanMotionResponse::OUTCOME_NOT_SET);
  EXPECT_TRUE(answers.at("good").response().has_undecided());
}

TEST(BatchCall, AnIdThatIsNoneIsAnErrorOfThatRequest) {
  const TestServer server;
  grpc::ClientContext context;
  const auto stream = server.stub()->PlanMotionBatch(&context);
  for (const std::string& id : {std::string("once"), std::string(""), std::string(65, 'x'), std::string("once")}) {
    stream->Write(batch_request(id));
  }
  stream->WritesDone();
  std::map<std::string, int> errors;
  int answered = 0;
  for (Response answer; stream->Read(&answer);) {
    if (answer.has_response()) {
      EXPECT_EQ(answer.request_id(), "once");
      ++answered;
      continue;
    }
    EXPECT_EQ(answer.error().code(), Code::INVALID_ARGUMENT);
    EXPECT_EQ(detail_of<google::rpc::BadRequest>(answer.error()).field_violations(0).field(), "request_id");
    ++errors[answer.request_id()];
  }
  EXPECT_TRUE(stream->Finish().ok());
  EXPECT_EQ(answered, 1);
  EXPECT_EQ(errors, (std::map<std::string, int>{{"once", 1}, {"", 1}, {std::string(64, 'x'), 1}}));
}

TEST(BatchCall, BytesThatAreNoMessageDoNotEndTheStream) {
  const TestServer server;
  grpc::GenericStub stub(server.channel());
  grpc::ClientContext context;
  grpc::CompletionQueue queue;
  const auto call = stub.PrepareCall(&context, "/dualarm.planning.v1.PlanningService/PlanMotionBatch", &queue);
  const auto step = [&queue] {
    void* tag = nullptr;
    bool ok = false;
    return queue.Next(&tag, &ok) && ok;
  };
  call->StartCall(nullptr);
  ASSERT_TRUE(step());
  for (const std::string& bytes : {std::string("\xff\xff\xff"), batch_request("good").SerializeAsString()}) {
    const grpc::Slice slice(bytes);
    call->Write(grpc::ByteBuffer(&slice, 1), nullptr);
    ASSERT_TRUE(step());
  }
  std::map<std::string, Response> answers;
  for (int i = 0; i < 2; ++i) {
    grpc::ByteBuffer bytes;
    call->Read(&bytes, nullptr);
    ASSERT_TRUE(step());
    grpc::Slice slice;
    ASSERT_TRUE(bytes.DumpToSingleSlice(&slice).ok());
    Response answer;
    ASSERT_TRUE(answer.ParseFromArray(slice.begin(), static_cast<int>(slice.size())));
    answers[answer.request_id()] = answer;
  }
  EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(answers[""].error()).reason(), "MALFORMED_REQUEST");
  EXPECT_TRUE(answers["good"].has_response());
  call->WritesDone(nullptr);
  ASSERT_TRUE(step());
  grpc::Status status;
  call->Finish(&status, nullptr);
  ASSERT_TRUE(step());
  EXPECT_TRUE(status.ok()) << status.error_message();
}

TEST(BatchCall, WaitsWhereASingleCallIsRefused) {
  ServerOptions options = patient_options();
  options.worker_threads = 1;
  options.queue_capacity = 0;
  options.search_threads = 1;
  options.search_queue = 0;
  const TestServer server(functions_with(search_planning(echo)), options);
  std::vector<Request> requests;
  for (int i = 0; i < 300; ++i) requests.push_back(batch_request(std::to_string(i)));
  for (const auto& [id, answer] : answers_to(server, requests)) EXPECT_TRUE(answer.has_response()) << id;
}

TEST(BatchCall, KeepsNoMoreInFlightThanItsLimit) {
  std::atomic<int> planned = 0;
  std::promise<void> release;
  const std::shared_future<void> released = release.get_future().share();
  ServerOptions options = patient_options();
  options.worker_threads = 8;
  options.batch_in_flight = 3;
  const TestServer server(functions_with(quick_planning([&planned, released](const auto&...) {
                            ++planned;
                            released.wait();
                            return undecided("");
                          })),
                          options);
  std::vector<Request> requests;
  for (int i = 0; i < 100; ++i) requests.push_back(batch_request(std::to_string(i)));
  auto answers = std::async(std::launch::async, [&] { return answers_to(server, requests); });
  while (planned < 3) std::this_thread::yield();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // in which more would begin if they were read
  EXPECT_EQ(planned, 3);
  release.set_value();
  EXPECT_EQ(answers.get().size(), 100u);
}

// The answers are large and the network keeps few of them.
TEST(BatchCall, AReaderWhoDoesNotReadStopsThePlanning) {
  constexpr int kCount = 600;
  std::atomic<int> planned = 0;
  const TestServer server(functions_with(quick_planning([&planned](const Problem&, const auto&...) {
    ++planned;
    return undecided(std::string(200'000, 'x'));
  })));
  grpc::ClientContext context;
  const auto stream = server.stub()->PlanMotionBatch(&context);
  std::thread writer([&] {
    for (int i = 0; i < kCount; ++i) stream->Write(batch_request(std::to_string(i)));
    stream->WritesDone();
  });
  int before = -1;
  while (before != planned) {
    before = planned;
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  EXPECT_GE(planned, ServerOptions().batch_in_flight);
  EXPECT_LT(planned, kCount / 2);
  EXPECT_EQ(read_all(*stream).size(), static_cast<std::size_t>(kCount));
  writer.join();
  EXPECT_TRUE(stream->Finish().ok());
  EXPECT_EQ(planned, kCount);
}

TEST(BatchCall, ACallerWhoCancelsStopsTheWork) {
  std::promise<void> begun;
  std::promise<bool> cancelled;
  const TestServer server(functions_with(search_planning([&](const auto&, const Budget& budget, const auto&) {
                            begun.set_value();
                            while (!budget.exhausted()) std::this_thread::yield();
                            cancelled.set_value(budget.cancelled());
                            return undecided("");
                          })),
                          patient_options());
  grpc::ClientContext context;
  const auto stream = server.stub()->PlanMotionBatch(&context);
  stream->Write(batch_request("endless"));
  begun.get_future().wait();
  context.TryCancel();
  EXPECT_TRUE(cancelled.get_future().get());
  EXPECT_TRUE(read_all(*stream).empty());
  EXPECT_EQ(stream->Finish().error_code(), Code::CANCELLED);
}

TEST(BatchCall, ClientsThatGoAwayAtAnyMomentLeaveNothingBehind) {
  ServerOptions options = patient_options();
  options.batch_in_flight = 5;
  options.max_streams = 1;  // a call that did not end would keep its place
  const TestServer server(functions_with(search_planning(echo)), options);
  for (int i = 0; i < 100; ++i) {
    {
      grpc::ClientContext context;
      const auto stream = server.stub()->PlanMotionBatch(&context);
      for (int j = 0; j < i; ++j) stream->Write(batch_request(std::to_string(j)));
      Response answer;
      if (i % 3 == 1) stream->Read(&answer);
      context.TryCancel();
    }
    for (bool is_free = false; !is_free;) {
      grpc::ClientContext context;
      const auto stream = server.stub()->PlanMotionBatch(&context);
      stream->WritesDone();
      is_free = stream->Finish().ok();
    }
  }
}

}  // namespace
}  // namespace dualarm
