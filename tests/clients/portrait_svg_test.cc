#include "clients/cpp/portrait_svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clients/cpp/wording.h"
#include "tests/clients/sample_answers.h"
#include "tests/clients/svg_paths.h"

namespace dualarm {
namespace {

using namespace planning::v1;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kLimit = "#8a99a6";
constexpr const char* kSwitching = "#8e44ad";
constexpr const char* kAccelerate = "#1b8a5a";
constexpr const char* kBrake = "#c23b18";
constexpr double kPixel = 0.02;  // numbers are written with two decimals

std::string drawing(const GetPhasePortraitResponse& response, int task = 0) {
  return portrait_svg("two_arms", sample_request().tasks(task), response);
}

/// Pixels a degree and a rad/s, and the origin, from the start and the switch of the sample's motion.
struct Axes {
  double x0, y0, per_degree, per_speed;

  explicit Axes(const std::string& svg) {
    const auto arc = path_with(svg, kAccelerate);
    per_degree = (arc.back().x - arc.front().x) / to_degrees(0.25);
    per_speed = (arc.front().y - arc.back().y) / 0.5;
    x0 = arc.front().x - to_degrees(0.5) * per_degree;
    y0 = arc.front().y;
  }
  Pixel at(double position, double velocity) const {
    return {x0 + to_degrees(position) * per_degree, y0 - velocity * per_speed};
  }
};

void expect_near(Pixel pixel, Pixel expected) {
  EXPECT_NEAR(pixel.x, expected.x, 10 * kPixel);
  EXPECT_NEAR(pixel.y, expected.y, 10 * kPixel);
}

TEST(PortraitSvg, IsWellFormedWhateverTheNamesAre) {
  EXPECT_TRUE(is_well_formed(drawing(sample_portrait())));
  const std::string svg = drawing(sample_portrait(), 1);  // the arm is called <right>
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("two_arms, &lt;right&gt;: 2.0000 s"));
  EXPECT_FALSE(is_well_formed("<svg><g></svg>"));
}

TEST(PortraitSvg, ColoursTheArcsByTheirKindAndJoinsThem) {
  const std::string svg = drawing(sample_portrait());
  const auto first = paths_with(svg, kAccelerate);
  const auto second = paths_with(svg, kBrake);
  ASSERT_EQ(first.size(), 1u);
  ASSERT_EQ(second.size(), 1u);
  EXPECT_GT(first[0].size(), 15u);
  EXPECT_EQ(first[0].back().x, second[0].front().x);
  EXPECT_EQ(first[0].back().y, second[0].front().y);
  const Axes axes(svg);
  expect_near(second[0].back(), axes.at(1.0, 0.0));
  expect_near(first[0][10], axes.at(0.5 + 0.25 * 0.25, 0.25));
  EXPECT_THAT(svg, HasSubstr("fastest motion: accelerate"));
  EXPECT_THAT(svg, HasSubstr("fastest motion: brake"));
  EXPECT_THAT(svg, Not(HasSubstr("fastest motion: cruise")));
}

TEST(PortraitSvg, DrawsLimitsInPiecesAndBothBranchesOfTheSwitchingCurve) {
  const std::string svg = drawing(sample_portrait());
  const Axes axes(svg);
  const auto limits = paths_with(svg, kLimit);
  ASSERT_EQ(limits.size(), 3u);  // the upper one has a gap
  expect_near(limits[0].front(), axes.at(0.0, 0.8));
  expect_near(limits[0].back(), axes.at(0.5, 0.8));
  expect_near(limits[1].front(), axes.at(1.0, 0.8));
  expect_near(limits[2].back(), axes.at(1.25, -0.8));
  const auto switching = paths_with(svg, kSwitching);
  ASSERT_EQ(switching.size(), 2u);
  expect_near(switching[0].front(), axes.at(0.5, 0.7));
  expect_near(switching[1].back(), axes.at(1.25, -0.5));
}

TEST(PortraitSvg, MarksStartGoalAndSwitches) {
  const std::string svg = drawing(sample_portrait());
  const Axes axes(svg);
  const auto ends = circles_with(svg, "stroke-width:3.5");
  ASSERT_EQ(ends.size(), 2u);  // and its sample in the legend
  expect_near(ends[0], axes.at(0.5, 0.0));
  const auto goal = circles_with(svg, "fill:#22303c");
  ASSERT_EQ(goal.size(), 2u);
  expect_near(goal[0], axes.at(1.0, 0.0));
  const auto switches = circles_with(svg, "stroke-width:1.4");
  ASSERT_EQ(switches.size(), 2u);
  expect_near(switches[0], axes.at(0.75, 0.5));
  EXPECT_THAT(svg, HasSubstr(">start</text>"));
  EXPECT_THAT(svg, HasSubstr(">goal</text>"));
}

TEST(PortraitSvg, NamesTheAxesWithTheirUnits) {
  const std::string svg = drawing(sample_portrait());
  EXPECT_THAT(svg, HasSubstr("position of left [deg]"));
  EXPECT_THAT(svg, HasSubstr("velocity [rad/s]"));
  EXPECT_THAT(svg, HasSubstr(">-0.4</text>"));
  EXPECT_THAT(svg, HasSubstr("Proven optimal"));
}

TEST(PortraitSvg, ShowsTheMotionWhereTheLimitsAreFarAway) {
  GetPhasePortraitResponse response = sample_portrait();
  for (double& velocity : *response.mutable_curves(0)->mutable_velocity_rad_per_s()) velocity = 1e6;
  const std::string svg = drawing(response);
  const auto arc = path_with(svg, kAccelerate);
  EXPECT_GT(arc.front().y - arc.back().y, 100.0);
  EXPECT_TRUE(is_well_formed(svg));
}

TEST(PortraitSvg, WithoutAMotionSaysSoAndDrawsTheCurves) {
  GetPhasePortraitResponse response = sample_portrait();
  response.mutable_curves()->RemoveLast();
  response.clear_arcs();
  response.clear_duration_s();
  response.mutable_infeasible()->set_reason(REASON_GOAL_TOO_FAST);
  const std::string svg = drawing(response);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("two_arms, left: no motion, goal too fast"));
  EXPECT_TRUE(paths_with(svg, kAccelerate).empty());
  EXPECT_EQ(paths_with(svg, kLimit).size(), 3u);
  response.clear_infeasible();
  response.mutable_undecided();
  EXPECT_THAT(drawing(response), HasSubstr("two_arms, left: undecided"));
}

TEST(PortraitSvg, OfNothingButAStateIsStillADrawing) {
  GetPhasePortraitResponse response;
  response.set_duration_s(0.0);
  ArmTask task;
  task.set_arm("left");
  const std::string svg = portrait_svg("x", task, response);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

}  // namespace
}  // namespace dualarm
