#include "clients/cpp/plan_svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/clients/sample_answers.h"
#include "tests/clients/svg_paths.h"

namespace dualarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(PlanSvg, ShowsWaitingAsAStraightStretchOfTheOtherArm) {
  const std::string svg = plan_svg("two_arms", sample_request(), sample_plan(), sample_region());
  const auto path = path_with(svg, "fill:none");
  ASSERT_GT(path.size(), 100U);
  // For the first second left waits: theta1 stays, theta2 falls, so y (downwards) grows.
  EXPECT_DOUBLE_EQ(path[0].x, path[50].x);
  EXPECT_LT(path[0].y, path[50].y);
  // In the last second <right> has arrived.
  EXPECT_DOUBLE_EQ(path[path.size() - 50].y, path.back().y);
  EXPECT_LT(path[path.size() - 50].x, path.back().x);
}

TEST(PlanSvg, DrawsTheForbiddenSetWhereItIs) {
  const std::string svg = plan_svg("two_arms", sample_request(), sample_plan(), sample_region());
  const auto square = path_with(svg, "#e4572e");
  const auto path = path_with(svg, "fill:none");
  ASSERT_EQ(square.size(), 4U);
  ASSERT_FALSE(path.empty());
  const double pixels_per_radian = (square[1].x - square[0].x) / 0.2;
  EXPECT_NEAR(square[0].y - square[2].y, 0.2 * pixels_per_radian, 0.02);
  EXPECT_NEAR(path.front().x - square[0].x, (0.5 - 0.2) * pixels_per_radian, 0.1);
  EXPECT_NEAR(square[0].y - path.front().y, (2.0 - 0.2) * pixels_per_radian, 0.1);
}

TEST(PlanSvg, EscapesNamesAndTellsTheDuration) {
  const std::string svg = plan_svg("two_arms", sample_request(), sample_plan(), sample_region());
  EXPECT_THAT(svg, StartsWith("<svg xmlns="));
  EXPECT_THAT(svg, HasSubstr("two_arms: delay plan, 3.0000 s"));
  EXPECT_THAT(svg, HasSubstr("theta2, &lt;right&gt; [deg]"));
  EXPECT_THAT(svg, Not(HasSubstr("<right>")));
}

TEST(PlanSvg, WithoutAPlanSaysSoAndDrawsNoPath) {
  const std::string svg = plan_svg("two_arms", sample_request(), sample_infeasible(), sample_region());
  EXPECT_THAT(svg, HasSubstr("two_arms: no plan, torque too small"));
  EXPECT_TRUE(path_with(svg, "fill:none").empty());
  EXPECT_EQ(path_with(svg, "#e4572e").size(), 4U);
}

TEST(RegionRequest, AsksForTheSetThatThePlanHadToAvoid) {
  auto request = sample_request();
  request.mutable_options()->set_clearance_m(0.5);
  request.mutable_options()->set_region_model(planning::v1::REGION_MODEL_PAPER);
  request.mutable_scene()->add_objects()->set_name("beam");
  const auto region = region_request_for(request);
  EXPECT_EQ(region.robot().arms(1).name(), "<right>");
  EXPECT_EQ(region.clearance_m(), 0.5);
  EXPECT_EQ(region.region_model(), planning::v1::REGION_MODEL_PAPER);
  EXPECT_EQ(region.scene().objects(0).name(), "beam");
}

}  // namespace
}  // namespace dualarm
