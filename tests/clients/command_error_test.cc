#include "clients/cpp/command_error.h"

#include <gmock/gmock.h>
#include <google/rpc/error_details.pb.h>
#include <google/rpc/status.pb.h>
#include <gtest/gtest.h>

namespace dualarm {
namespace {

using ::testing::HasSubstr;

ExitStatus status_for(grpc::StatusCode code) { return error_of_call({code, "why"}, "here:1").status(); }

TEST(ErrorOfCall, EndsWithTheExitStatusOfItsCode) {
  EXPECT_EQ(status_for(grpc::StatusCode::INVALID_ARGUMENT), ExitStatus::kInvalid);
  EXPECT_EQ(status_for(grpc::StatusCode::UNIMPLEMENTED), ExitStatus::kInvalid);
  EXPECT_EQ(status_for(grpc::StatusCode::UNAUTHENTICATED), ExitStatus::kInvalid);
  EXPECT_EQ(status_for(grpc::StatusCode::DEADLINE_EXCEEDED), ExitStatus::kUndecided);
  EXPECT_EQ(status_for(grpc::StatusCode::UNAVAILABLE), ExitStatus::kUnreachable);
  EXPECT_EQ(status_for(grpc::StatusCode::RESOURCE_EXHAUSTED), ExitStatus::kUnreachable);
  EXPECT_EQ(status_for(grpc::StatusCode::CANCELLED), ExitStatus::kInterrupted);
  EXPECT_EQ(status_for(grpc::StatusCode::INTERNAL), ExitStatus::kFailure);
}

TEST(ErrorOfCall, NamesTheServerThatDoesNotAnswer) {
  EXPECT_THAT(error_of_call({grpc::StatusCode::UNAVAILABLE, "refused"}, "here:1").what(),
              ::testing::StrEq("no answer from here:1: refused"));
}

TEST(ErrorOfCall, ListsEveryFieldViolationOnALineOfItsOwn) {
  google::rpc::BadRequest bad_request;
  for (const char* field : {"robot.arms[0].link.length_m", "tasks[1].arm"}) {
    auto* violation = bad_request.add_field_violations();
    violation->set_field(field);
    violation->set_description("must not be so");
  }
  google::rpc::Status rich;
  rich.set_code(static_cast<int>(grpc::StatusCode::INVALID_ARGUMENT));
  rich.add_details()->PackFrom(google::rpc::ErrorInfo());
  rich.add_details()->PackFrom(bad_request);
  const grpc::Status status(grpc::StatusCode::INVALID_ARGUMENT, "2 violations", rich.SerializeAsString());
  EXPECT_STREQ(error_of_call(status, "here:1").what(),
               "2 violations\n  robot.arms[0].link.length_m: must not be so\n  tasks[1].arm: must not be so");
}

TEST(ErrorOfCall, SurvivesDetailsThatAreNotAStatus) {
  const grpc::Status status(grpc::StatusCode::INVALID_ARGUMENT, "odd", "\xff\xff\xff");
  EXPECT_THAT(error_of_call(status, "here:1").what(), HasSubstr("odd"));
}

}  // namespace
}  // namespace dualarm
