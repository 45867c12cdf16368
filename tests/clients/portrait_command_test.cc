// dualarm portrait, the real program against the real server: exit statuses, what is printed, what is drawn.
#include <gmock/gmock.h>
#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "dualarm/planning/v1/planning_service.pb.h"
#include "tests/clients/command_fixture.h"
#include "tests/clients/scenarios.h"
#include "tests/clients/svg_paths.h"

namespace dualarm {
namespace {

namespace fs = std::filesystem;
using namespace planning::v1;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class PortraitCommandLine : public CommandFixture {
 protected:
  PortraitCommandLine() : CommandFixture("portrait") {}

  GetPhasePortraitResponse answer_to(std::vector<std::string> arguments) {
    arguments.push_back("--json");
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_status, 0) << result.err;
    GetPhasePortraitResponse response;
    EXPECT_TRUE(google::protobuf::util::JsonStringToMessage(result.out, &response).ok()) << result.out.substr(0, 200);
    return response;
  }
};

TEST_F(PortraitCommandLine, PrintsTheMotionAndDrawsIt) {
  const auto result = run({scenario("portrait_paper"), "--arm", "arm1", "--svg", file("portrait.svg")});
  EXPECT_EQ(result.exit_status, 0) << result.err;
  EXPECT_THAT(result.out, StartsWith("portrait_paper, arm1: the fastest motion"));
  EXPECT_THAT(result.out, HasSubstr("accelerate to brake"));
  EXPECT_THAT(result.err, IsEmpty());
  const std::string svg = read_text(file("portrait.svg"));
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("portrait_paper, arm1: "));
}

TEST_F(PortraitCommandLine, DrawsEveryScenarioWellFormed) {
  for (const auto& entry : fs::directory_iterator(fs::path(DUALARM_SOURCE_DIR) / "scenarios")) {
    if (entry.path().extension() != ".json") continue;
    SCOPED_TRACE(entry.path());
    const PlanMotionRequest request = request_of(entry.path().stem());
    const auto result = run({entry.path(), "--arm", request.tasks(1).arm(), "--svg", file("scenario.svg")});
    EXPECT_EQ(result.exit_status, 0) << result.out << result.err;
    EXPECT_TRUE(is_well_formed(read_text(file("scenario.svg"))));
  }
}

TEST_F(PortraitCommandLine, PrintsTheAnswerAsJsonWithTheResolutionAskedFor) {
  const auto response = answer_to({scenario("paper_case1"), "--arm", "arm2", "--resolution", "50"});
  EXPECT_EQ(response.claim(), CLAIM_OPTIMAL);
  EXPECT_EQ(response.arcs_size(), 2);
  ASSERT_GE(response.curves_size(), 4);
  EXPECT_EQ(response.curves(0).position_rad_size(), 50);
}

// Theory, section 1.3: T/G = 0.76 swings back first; 5.790 in units of 1 / sqrt(g / l).
TEST_F(PortraitCommandLine, SwingsTheWeakArmBackFirst) {
  const auto response = answer_to({scenario("weak_swing"), "--arm", "swinging"});
  EXPECT_NEAR(response.duration_s() * std::sqrt(9.81), 5.790, 5e-4);
  ASSERT_EQ(response.arcs_size(), 4);
  EXPECT_LT(response.arcs(0).end().velocity_rad_per_s(), 0.0);
}

TEST_F(PortraitCommandLine, TurnsTheMovingStartRound) {
  const auto response = answer_to({scenario("moving_start"), "--arm", "arm1"});
  ASSERT_EQ(response.arcs_size(), 3);
  EXPECT_EQ(response.arcs(0).kind(), ARC_KIND_BRAKE);
  EXPECT_EQ(response.arcs(0).start().velocity_rad_per_s(), -0.3);
  EXPECT_LT(response.arcs(1).start().position_rad(), response.arcs(0).start().position_rad());
}

TEST_F(PortraitCommandLine, EndsWithTwoForWhatIsNoRequest) {
  EXPECT_EQ(run({}).exit_status, 2);
  EXPECT_EQ(run({scenario("paper_case1")}).exit_status, 2);  // no --arm
  const auto nobody = run({scenario("paper_case1"), "--arm", "nobody"});
  EXPECT_EQ(nobody.exit_status, 2);
  EXPECT_THAT(nobody.err, HasSubstr("has no task for arm 'nobody': give --arm arm1 or arm2"));
  const auto fine = run({scenario("paper_case1"), "--arm", "arm1", "--resolution", "20000"});
  EXPECT_EQ(fine.exit_status, 2);
  EXPECT_THAT(fine.err, HasSubstr("resolution: is 20000, must be 2 to 10000 points"));
  EXPECT_EQ(run({"/nowhere.json", "--arm", "arm1"}).exit_status, 2);
}

TEST_F(PortraitCommandLine, EndsWithThreeWhereNoMotionExistsAndStillDraws) {
  PlanMotionRequest request = request_of("paper_case1");
  request.mutable_tasks(0)->mutable_start()->set_velocity_rad_per_s(-1.9);  // the joint range ends 20 degrees on
  const auto result = run({"-", "--arm", "arm1", "--svg", file("none.svg")}, json_of(request));
  EXPECT_EQ(result.exit_status, 3) << result.out << result.err;
  EXPECT_THAT(result.out, StartsWith("stdin, arm1: no motion exists"));
  EXPECT_THAT(result.out, HasSubstr("start too fast"));
  EXPECT_TRUE(is_well_formed(read_text(file("none.svg"))));
}

TEST_F(PortraitCommandLine, EndsWithFiveWhereNoServerAnswers) {
  EXPECT_EQ(run({scenario("paper_case1"), "--arm", "arm1", "--server", "unix:" + file("nobody")}).exit_status, 5);
}

TEST_F(PortraitCommandLine, EndsWithOneWhereTheDrawingCannotBeWritten) {
  EXPECT_EQ(run({scenario("paper_case1"), "--arm", "arm1", "--svg", file("no/such/folder.svg")}).exit_status, 1);
}

}  // namespace
}  // namespace dualarm
