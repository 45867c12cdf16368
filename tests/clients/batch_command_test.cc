// dualarm batch and dualarm plan --progress: the real program against the real server.
#include <gmock/gmock.h>
#include <google/protobuf/util/json_util.h>
#include <google/rpc/error_details.pb.h>

#include <set>
#include <sstream>

#include "clients/cpp/json_file.h"
#include "dualarm/planning/v1/planning_service.pb.h"
#include "tests/clients/command_fixture.h"
#include "tests/clients/scenarios.h"

namespace dualarm {
namespace {

using planning::v1::PlanMotionBatchResponse;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class BatchCommandLine : public CommandFixture {
 protected:
  BatchCommandLine() : CommandFixture("batch") {}
};

class ProgressCommandLine : public CommandFixture {
 protected:
  ProgressCommandLine() : CommandFixture("plan") {}
};

TEST_F(BatchCommandLine, PlansFilesIntoATable) {
  const auto result = run({scenario("paper_case1"), scenario("paper_case3"), "/nowhere.json"});
  EXPECT_EQ(result.exit_status, 2);
  EXPECT_THAT(result.out, AllOf(HasSubstr("\npaper_case1      "), HasSubstr("\npaper_case3      "),
                                HasSubstr("\nnowhere          ERROR         /nowhere.json: cannot be read")));
  EXPECT_THAT(result.err, IsEmpty());
}

TEST_F(BatchCommandLine, AnswersLinesByLines) {
  constexpr int kCount = 300;
  auto request = request_of("paper_case1");
  std::string input;
  for (int i = 0; i < kCount; ++i) input += json_line_of(request);
  request.mutable_tasks(0)->set_arm("nobody");
  input += json_line_of(request);
  const auto result = run({"-", "--json"}, input);
  EXPECT_EQ(result.exit_status, 2) << result.err;
  EXPECT_THAT(result.err, IsEmpty());
  std::istringstream lines(result.out);
  std::set<std::string> planned;
  for (std::string line; std::getline(lines, line);) {
    PlanMotionBatchResponse answer;
    ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(line, &answer).ok()) << line.substr(0, 200);
    if (answer.response().has_plan()) planned.insert(answer.request_id());
    if (answer.request_id() == "line 301") {
      google::rpc::BadRequest bad_request;
      ASSERT_TRUE(answer.error().details(0).UnpackTo(&bad_request));
      EXPECT_EQ(bad_request.field_violations(0).field(), "tasks[0].arm");
    }
  }
  EXPECT_EQ(planned.size(), static_cast<std::size_t>(kCount));
}

TEST_F(BatchCommandLine, EndsWhereItsAnswersCannotBeWrittenOrNoServerIsThere) {
  const std::string words = "exec " DUALARM_PROGRAM " batch " DUALARM_SOURCE_DIR "/scenarios --json > /dev/full";
  const auto full = ProgramRun({"/bin/sh", "-c", words}, {}, file("."), "").wait();
  EXPECT_EQ(full.exit_status, 1);
  EXPECT_THAT(full.err, HasSubstr("stdout: cannot be written"));
  const auto nobody = run({scenario("paper_case1"), "--server", "unix:" + file("nobody")});
  EXPECT_EQ(nobody.exit_status, 5);
}

TEST_F(ProgressCommandLine, TellsOfPlansOnStderrAndAnswersOnStdout) {
  const auto result = run({scenario("paper_case1"), "--progress", "--json"});
  EXPECT_EQ(result.exit_status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("a plan of 1.81"));
  planning::v1::PlanMotionResponse response;
  ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(result.out, &response).ok());
  EXPECT_TRUE(response.has_plan());
}

}  // namespace
}  // namespace dualarm
