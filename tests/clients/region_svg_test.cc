#include "clients/cpp/region_svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clients/cpp/command_error.h"
#include "clients/cpp/region_polygons.h"
#include "clients/cpp/region_report.h"
#include "clients/cpp/region_sets.h"
#include "tests/clients/sample_answers.h"
#include "tests/clients/svg_paths.h"

namespace dualarm {
namespace {

using namespace planning::v1;
using ::testing::HasSubstr;
using ::testing::Not;

PlanMotionRequest request_with(double clearance) {
  PlanMotionRequest request = sample_request();
  request.mutable_options()->set_clearance_m(clearance);
  return request;
}

/// The sample's square, a bit larger for the paper's set and with a clearance.
GetForbiddenRegionResponse answer_to(const GetForbiddenRegionRequest& request) {
  GetForbiddenRegionResponse region = sample_region();
  const double more = (request.region_model() == REGION_MODEL_PAPER ? 0.2 : 0.0) + request.clearance_m();
  for (const int corner : {1, 2}) region.mutable_contours(0)->set_theta1_rad(corner, 0.4 + more);
  return region;
}

std::vector<RegionSet> sample_sets(double clearance) { return region_sets(request_with(clearance), 7, answer_to); }

TEST(RegionSets, AreTheExactAndThePapersWithAndWithoutTheClearance) {
  const auto sets = sample_sets(0.1);
  ASSERT_EQ(sets.size(), 4u);
  EXPECT_EQ(sets[0].name, "paper's set, with margin");
  EXPECT_EQ(sets[1].name, "paper's set");
  EXPECT_EQ(sets[2].name, "exact set, with margin");
  EXPECT_EQ(sets[3].name, "exact set");
  EXPECT_EQ(sets[2].clearance_m, 0.1);
  EXPECT_EQ(sets[3].clearance_m, 0.0);
  EXPECT_DOUBLE_EQ(sets[0].region.contours(0).theta1_rad(1), 0.7);
}

TEST(RegionSets, AreTwoWhereNoClearanceIsDemanded) { EXPECT_EQ(sample_sets(0.0).size(), 2u); }

TEST(RegionSets, AskForTheArmsTheSceneAndTheResolution) {
  PlanMotionRequest request = request_with(0.1);
  request.mutable_scene()->add_objects()->set_name("load");
  for (const RegionSet& set : region_sets(request, 7, [](const GetForbiddenRegionRequest& asked) {
         EXPECT_EQ(asked.robot().arms_size(), 2);
         EXPECT_EQ(asked.scene().objects(0).name(), "load");
         EXPECT_EQ(asked.resolution(), 7);
         return answer_to(asked);
       })) {
    EXPECT_EQ(set.region.contours_size(), 1);
  }
}

TEST(RegionSets, DoWithoutThePapersSetForAnotherMounting) {
  const auto refuse_paper = [](const GetForbiddenRegionRequest& request) {
    if (request.region_model() == REGION_MODEL_PAPER) throw CommandError(ExitStatus::kInvalid, "mounting");
    return answer_to(request);
  };
  EXPECT_EQ(region_sets(request_with(0.1), 7, refuse_paper).size(), 2u);
  const auto refuse_all = [](const GetForbiddenRegionRequest&) -> GetForbiddenRegionResponse {
    throw CommandError(ExitStatus::kInvalid, "no arms");
  };
  EXPECT_THROW(region_sets(request_with(0.1), 7, refuse_all), CommandError);
  const auto go_away = [](const GetForbiddenRegionRequest& request) {
    if (request.region_model() == REGION_MODEL_PAPER) throw CommandError(ExitStatus::kUnreachable, "gone");
    return answer_to(request);
  };
  EXPECT_THROW(region_sets(request_with(0.1), 7, go_away), CommandError);
}

TEST(RegionSvg, DrawsEverySetWithItsStyleAndItsName) {
  const std::string svg = region_svg("two_arms", request_with(0.1), sample_sets(0.1));
  EXPECT_TRUE(is_well_formed(svg));
  const auto shapes = paths_with(svg, "fill-opacity");
  ASSERT_EQ(shapes.size(), 4u);
  // From the largest to the smallest, and 0.2 rad wide at last.
  const double radian = (shapes[3][1].x - shapes[3][0].x) / 0.2;
  EXPECT_NEAR(shapes[0][1].x - shapes[0][0].x, 0.5 * radian, 0.1);
  EXPECT_NEAR(shapes[1][1].x - shapes[1][0].x, 0.4 * radian, 0.1);
  EXPECT_NEAR(shapes[2][1].x - shapes[2][0].x, 0.3 * radian, 0.1);
  EXPECT_EQ(paths_with(svg, "stroke-dasharray").size(), 2u);
  for (const char* name : {"exact set", "exact set, with margin", "paper's set", "paper's set, with margin"}) {
    EXPECT_THAT(svg, HasSubstr(std::string(">") + name + "</text>"));
  }
  EXPECT_THAT(svg, HasSubstr("theta2, &lt;right&gt; [deg]"));
  EXPECT_THAT(svg, HasSubstr("a clearance of 0.100000 m"));
}

TEST(RegionSvg, SaysWhatIsLeftOutAndWhatIsEmpty) {
  PlanMotionRequest request = request_with(0.0);
  Object& mover = *request.mutable_scene()->add_objects();
  mover.set_name("<door>");
  mover.mutable_moving();
  Object& wall = *request.mutable_scene()->add_objects();
  wall.set_name("wall");
  wall.mutable_fixed();
  std::vector<RegionSet> sets = sample_sets(0.0);
  sets[1].region.clear_contours();
  const std::string svg = region_svg("two_arms", request, sets);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("left out, on clocks of their own: &lt;door&gt;"));
  EXPECT_THAT(svg, HasSubstr("left out, in the way of one arm only: wall"));
  EXPECT_THAT(svg, HasSubstr("exact set: empty"));
  EXPECT_THAT(svg, Not(HasSubstr("paper's set: empty")));
}

TEST(RegionReport, TellsAreaShareAndExtentOfEverySet) {
  const std::string report = region_report("two_arms", request_with(0.0), sample_sets(0.0));
  EXPECT_THAT(report, HasSubstr("two_arms: where left and <right> collide"));
  EXPECT_THAT(report, HasSubstr("theta1, left"));
  // 0.2 rad squared are 131.31 square degrees, of 180 squared.
  EXPECT_THAT(report, HasSubstr("131.31 deg2"));
  EXPECT_THAT(report, HasSubstr("0.41 %"));
  EXPECT_THAT(report, HasSubstr("11.4592 to 22.9183 deg"));
  EXPECT_THAT(report, HasSubstr("11.4592 to 34.3775 deg"));
  EXPECT_THAT(report, Not(HasSubstr("left out")));
}

TEST(RegionReport, KnowsEmptySets) {
  std::vector<RegionSet> sets = sample_sets(0.0);
  for (RegionSet& set : sets) set.region.clear_contours();
  const std::string report = region_report("two_arms", request_with(0.0), sets);
  EXPECT_THAT(report, HasSubstr("0.00 deg2"));
  EXPECT_THAT(report, Not(HasSubstr("inf")));
}

TEST(RegionPolygons, HaveTheAreaOfTheirInside) {
  const std::vector<PlotPoint> outer = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const std::vector<PlotPoint> hole = {{1, 1}, {1, 2}, {2, 2}, {2, 1}};
  EXPECT_DOUBLE_EQ(area_of({outer}), 16.0);
  EXPECT_DOUBLE_EQ(area_of({outer, hole}), 15.0);
}

}  // namespace
}  // namespace dualarm
