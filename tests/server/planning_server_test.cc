#include "server/planning_server.h"

#include <gmock/gmock.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/generic/generic_stub.h>

#include <future>

#include "tests/server/paper_request.h"
#include "tests/server/test_server.h"

namespace dualarm {
namespace {

using ::testing::HasSubstr;

// What reflection answers to a request, both in protobuf's own bytes; "" where it does not.
std::string reflected(const std::shared_ptr<grpc::Channel>& channel, const std::string& request) {
  grpc::GenericStub stub(channel);
  grpc::ClientContext context;
  grpc::CompletionQueue queue;
  const auto call =
      stub.PrepareCall(&context, "/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo", &queue);
  void* tag = nullptr;
  bool ok = false;
  const auto step = [&] { return queue.Next(&tag, &ok) && ok; };
  call->StartCall(nullptr);
  const grpc::Slice ask(request);
  grpc::ByteBuffer answer;
  if (!step()) return "";
  call->Write(grpc::ByteBuffer(&ask, 1), nullptr);
  if (!step()) return "";
  call->Read(&answer, nullptr);
  if (!step()) return "";
  context.TryCancel();
  grpc::Status status;
  call->Finish(&status, nullptr);
  step();
  grpc::Slice bytes;
  return answer.DumpToSingleSlice(&bytes).ok() ? std::string(bytes.begin(), bytes.end()) : "";
}

TEST(PlanningServer, ReportsHealthForTheServerAndPerService) {
  const TestServer server;
  EXPECT_EQ(health_of(server.channel(), ""), 1);
  EXPECT_EQ(health_of(server.channel(), "dualarm.planning.v1.PlanningService"), 1);
  EXPECT_EQ(health_of(server.channel(), "no.such.Service"), -1);
}

TEST(PlanningServer, ReflectsItsService) {
  const TestServer server;
  const std::string services = reflected(server.channel(), "\x3a\x01*");  // list_services = 7
  EXPECT_THAT(services, HasSubstr("dualarm.planning.v1.PlanningService"));
  EXPECT_THAT(services, HasSubstr("grpc.health.v1.Health"));
}

TEST(PlanningServer, ReflectsWhatItsServicesSay) {
  const TestServer server;
  const auto file_of = [&](const std::string& symbol) {  // file_containing_symbol = 4
    return reflected(server.channel(), std::string("\x22") + static_cast<char>(symbol.size()) + symbol);
  };
  EXPECT_THAT(file_of("dualarm.planning.v1.PlanningService"), HasSubstr("PlanMotionRequest"));
  EXPECT_THAT(file_of("grpc.health.v1.Health"), HasSubstr("HealthCheckResponse"));
}

TEST(PlanningServer, RefusesAHundredMegabytesAndGoesOn) {
  const TestServer server;
  wire::PlanMotionRequest large = paper_request();
  large.mutable_scene()->add_objects()->set_name(std::string(100'000'000, 'x'));
  grpc::ClientContext context;
  wire::PlanMotionResponse response;
  const auto stub = server.stub();
  const grpc::Status status = stub->PlanMotion(&context, large, &response);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_THAT(status.error_message(), HasSubstr("larger than max"));
  grpc::ClientContext next;
  EXPECT_TRUE(stub->PlanMotion(&next, paper_request(), &response).ok());
}

grpc::Status answer_to_bytes(const TestServer& server, const std::string& method, const std::string& bytes) {
  const grpc::Slice slice(bytes);
  const grpc::ByteBuffer request(&slice, 1);
  grpc::ByteBuffer response;
  grpc::ClientContext context;
  std::promise<grpc::Status> done;
  grpc::GenericStub(server.channel())
      .UnaryCall(&context, "/dualarm.planning.v1.PlanningService/" + method, {}, &request, &response,
                 [&done](grpc::Status status) { done.set_value(std::move(status)); });
  return done.get_future().get();
}

TEST(PlanningServer, SaysThatBytesAreNoRequest) {
  const TestServer server;
  for (const char* method :
       {"PlanMotion", "PlanMotionStream", "VerifyMotion", "GetForbiddenRegion", "GetPhasePortrait"}) {
    const grpc::Status status = answer_to_bytes(server, method, "\xff\xff\xff");
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT) << method;
    EXPECT_THAT(status.error_message(), HasSubstr(std::string("is not a dualarm.planning.v1.") + method + "Request"));
  }
  EXPECT_EQ(answer_to_bytes(server, "NoSuchMethod", "").error_code(), grpc::StatusCode::UNIMPLEMENTED);
}

TEST(PlanningServer, ListensOnAFreePortAndSaysWhich) {
  PlanningServer server(listening_on("127.0.0.1:0"), quick_functions());
  EXPECT_GT(server.port(), 0);
  EXPECT_EQ(server.address(), "127.0.0.1:" + std::to_string(server.port()));
  EXPECT_EQ(health_of(grpc::CreateChannel(server.address(), grpc::InsecureChannelCredentials()), ""), 1);
}

std::string why_not(const std::string& listen) {
  try {
    const PlanningServer server(listening_on(listen), quick_functions());
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(PlanningServer, ASecondServerOnTheAddressIsRefused) {
  const PlanningServer first(listening_on("127.0.0.1:0"), quick_functions());
  EXPECT_THAT(why_not(first.address()), HasSubstr("cannot listen on " + first.address()));
  const TestServer on_socket;
  EXPECT_THAT(why_not(on_socket.address()), HasSubstr("another server listens on unix:"));
  EXPECT_EQ(health_of(on_socket.channel(), ""), 1);
}

TEST(PlanningServer, RefusesWhatIsNoAddressAndSaysWhatOneIs) {
  for (const char* address : {"127.0.0.1:99999", "127.0.0.1:65536", "127.0.0.1:-1", "127.0.0.1:http", "127.0.0.1:1x",
                              "127.0.0.1:", "127.0.0.1", ":50051", "::1:50051", "nonsense", "unix:", ""}) {
    EXPECT_THAT(why_not(address), HasSubstr("give HOST:PORT with a port of 0 to 65535")) << address;
  }
}

TEST(PlanningServer, SpeaksPlaintextToOtherMachinesOnlyWhenTold) {
  EXPECT_THAT(why_not("0.0.0.0:0"), HasSubstr("--allow-insecure-remote"));
  EXPECT_THAT(why_not("[::]:0"), HasSubstr("--allow-insecure-remote"));
  ServerOptions options = listening_on("0.0.0.0:0");
  options.allow_insecure_remote = true;
  const PlanningServer server(options, quick_functions());
  EXPECT_GT(server.port(), 0);
}

TEST(PlanningServer, DrainingFinishesRunningCallsAndRefusesNewOnes) {
  std::promise<void> begun;
  std::promise<void> release;
  TestServer server(functions_with(quick_planning([&](const auto&...) {
    begun.set_value();
    release.get_future().wait();
    return undecided("finished");
  })));
  const auto stub = server.stub();
  wire::PlanMotionResponse response;
  std::future<grpc::Status> running = std::async(std::launch::async, [&] {
    grpc::ClientContext context;
    return stub->PlanMotion(&context, paper_request(), &response);
  });
  begun.get_future().wait();
  std::future<void> drained = std::async(std::launch::async, [&] { server.server().drain(std::chrono::seconds(60)); });
  grpc::StatusCode refused = grpc::StatusCode::OK;
  for (int i = 0; i < 1000 && refused != grpc::StatusCode::UNAVAILABLE; ++i) {
    grpc::ClientContext context;
    // A connection that the closing listener accepted last is never answered; the next one is refused.
    context.set_deadline(std::chrono::system_clock::now() + std::chrono::milliseconds(200));
    wire::VerifyMotionResponse unused;
    refused = server.stub()->VerifyMotion(&context, paper_verify_request(), &unused).error_code();
  }
  EXPECT_EQ(refused, grpc::StatusCode::UNAVAILABLE);
  release.set_value();
  drained.wait();
  EXPECT_TRUE(running.get().ok());
  EXPECT_EQ(response.undecided().explanation(), "finished");
}

TEST(PlanningServer, DrainingAnswersWhatABatchHasReadAndEndsItEvenIfItIsSilent) {
  TestServer server;
  const auto stub = server.stub();
  grpc::ClientContext context;
  const auto batch = stub->PlanMotionBatch(&context);
  wire::PlanMotionBatchRequest request;
  request.set_request_id("first");
  *request.mutable_request() = paper_request();
  ASSERT_TRUE(batch->Write(request));
  wire::PlanMotionBatchResponse answer;
  ASSERT_TRUE(batch->Read(&answer));
  EXPECT_TRUE(answer.has_response());
  const auto begin = std::chrono::steady_clock::now();
  server.server().drain(std::chrono::seconds(60));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
  EXPECT_FALSE(batch->Read(&answer));
  const grpc::Status status = batch->Finish();
  EXPECT_EQ(status.error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_THAT(status.error_message(), HasSubstr("send the requests that have no answer to another"));
}

TEST(PlanningServer, DrainingCancelsCallsWhenPatienceEnds) {
  std::promise<void> begun;
  TestServer server(functions_with(quick_planning([&](const Problem&, const Budget& budget, const Observer&) {
    begun.set_value();
    while (!budget.cancelled()) std::this_thread::yield();
    return undecided("");
  })));
  std::future<grpc::Status> running = std::async(std::launch::async, [&] {
    grpc::ClientContext context;
    wire::PlanMotionResponse response;
    return server.stub()->PlanMotion(&context, paper_request(), &response);
  });
  begun.get_future().wait();
  server.server().drain(std::chrono::milliseconds(20));
  EXPECT_FALSE(running.get().ok());
}

}  // namespace
}  // namespace dualarm
