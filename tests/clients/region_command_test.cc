// dualarm region, the real program against the real server: exit statuses, what is printed, what is drawn.
#include <gmock/gmock.h>
#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "dualarm/planning/v1/planning_service.pb.h"
#include "tests/clients/command_fixture.h"
#include "tests/clients/scenarios.h"
#include "tests/clients/svg_paths.h"

namespace dualarm {
namespace {

using namespace planning::v1;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

class RegionCommandLine : public CommandFixture {
 protected:
  RegionCommandLine() : CommandFixture("region") {}
};

TEST_F(RegionCommandLine, PrintsTheSetsAndDrawsFigureTwo) {
  const auto result = run({scenario("tower_cranes"), "--svg", file("region.svg")});
  EXPECT_EQ(result.exit_status, 0) << result.err;
  EXPECT_THAT(result.out, StartsWith("tower_cranes: where crane_west and crane_east collide"));
  EXPECT_THAT(result.out, HasSubstr("paper's set, with margin"));
  EXPECT_THAT(result.err, IsEmpty());
  const std::string svg = read_text(file("region.svg"));
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_EQ(paths_with(svg, "fill-opacity").size(), 4u);
}

// Theory, section 2: the lens reaches asin(6/8) = 48.5904 degrees along theta1; arms of 0.1 m make it larger.
TEST_F(RegionCommandLine, PrintsTheSetToBeAvoidedAsJson) {
  const auto result = run({scenario("paper_case1"), "--json", "--resolution", "91"});
  EXPECT_EQ(result.exit_status, 0) << result.err;
  GetForbiddenRegionResponse response;
  ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(result.out, &response).ok());
  ASSERT_EQ(response.contours_size(), 1);
  double most = 0.0;
  for (const double theta1 : response.contours(0).theta1_rad()) most = std::max(most, theta1);
  EXPECT_GT(most, std::asin(0.75));
  EXPECT_LT(most, std::asin(0.75) + 0.03);
}

TEST_F(RegionCommandLine, LeavesThePapersSetOutForAnotherMounting) {
  PlanMotionRequest request = request_of("paper_case1");
  request.mutable_robot()->mutable_arms(1)->mutable_base()->set_y_m(0.5);
  const auto result = run({"-"}, json_of(request));
  EXPECT_EQ(result.exit_status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("exact set"));
  EXPECT_THAT(result.out, Not(HasSubstr("paper's set")));
}

TEST_F(RegionCommandLine, NamesWhatIsLeftOut) {
  PlanMotionRequest request = request_of("paper_case1");
  Object& wall = *request.mutable_scene()->add_objects();
  wall.set_name("wall");
  wall.mutable_sphere()->set_radius_m(0.1);
  wall.mutable_fixed()->set_y_m(-9.0);
  const auto result = run({"-"}, json_of(request));
  EXPECT_EQ(result.exit_status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("left out, in the way of one arm only: wall"));
}

TEST_F(RegionCommandLine, EndsWithTwoForWhatIsNoRequest) {
  EXPECT_EQ(run({}).exit_status, 2);
  EXPECT_EQ(run({"/nowhere.json"}).exit_status, 2);
  const auto fine = run({scenario("paper_case1"), "--resolution", "20000"});
  EXPECT_EQ(fine.exit_status, 2);
  EXPECT_THAT(fine.err, HasSubstr("resolution: is 20000, must be 2 to 2000 points"));
}

TEST_F(RegionCommandLine, EndsWithFiveWhereNoServerAnswers) {
  EXPECT_EQ(run({scenario("paper_case1"), "--server", "unix:" + file("nobody")}).exit_status, 5);
}

TEST_F(RegionCommandLine, EndsWithOneWhereTheDrawingCannotBeWritten) {
  EXPECT_EQ(run({scenario("paper_case1"), "--svg", file("no/such/folder.svg")}).exit_status, 1);
}

}  // namespace
}  // namespace dualarm
