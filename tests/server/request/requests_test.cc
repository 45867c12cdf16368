#include "server/request/requests.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/server/request/violation_cases.h"

namespace dualarm {
namespace {

TEST(Parse, AnEmptyRequestSaysWhatIsMissing) {
  const auto found = violations_of(wire::PlanMotionRequest());
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].field, "robot");
  EXPECT_EQ(found[1].field, "tasks");
  EXPECT_EQ(violations_of(wire::VerifyMotionRequest()).size(), 1u);
  EXPECT_EQ(violations_of(wire::GetForbiddenRegionRequest()).size(), 1u);
}

TEST(Parse, ListsAllViolationsAtOnce) {
  wire::PlanMotionRequest request = paper_request();
  request.mutable_robot()->mutable_arms(0)->mutable_link()->set_length_m(kNan);
  request.mutable_robot()->mutable_arms(1)->mutable_dynamics()->set_mass_kg(-1.0);
  request.mutable_robot()->mutable_arms(1)->clear_velocity_limit();
  request.mutable_tasks(0)->mutable_start()->set_position_rad(kInfinity);
  request.mutable_options()->set_clearance_m(-1.0);
  std::map<std::string, std::string> found;
  for (const FieldViolation& violation : violations_of(request)) found[violation.field] = violation.description;
  EXPECT_EQ(found.size(), 5u);
  EXPECT_TRUE(found.contains("robot.arms[0].link.length_m"));
  EXPECT_TRUE(found.contains("robot.arms[1].dynamics.mass_kg"));
  EXPECT_TRUE(found.contains("robot.arms[1].velocity_limit"));
  EXPECT_TRUE(found.contains("tasks[0].start.position_rad"));
  EXPECT_TRUE(found.contains("options.clearance_m"));
}

TEST(Parse, CountsMoreViolationsThanItKeeps) {
  wire::PlanMotionRequest request = paper_request();
  for (int i = 0; i < 500; ++i) request.mutable_scene()->add_objects();
  const auto parsed = parse(request);
  const auto& violations = std::get<Violations>(parsed);
  EXPECT_EQ(violations.count(), 1500u);
  EXPECT_EQ(violations.kept().size(), Violations::kMostKept);
}

TEST(Parse, ChecksTheResolutionOfARegion) {
  wire::GetForbiddenRegionRequest request;
  *request.mutable_robot() = paper_request().robot();
  const auto parsed = parse(request);
  EXPECT_EQ(std::get<RegionWish>(parsed).resolution, 181);
  for (const int resolution : {-1, 1, 2001}) {
    request.set_resolution(resolution);
    const auto found = violations_of(request);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].field, "resolution");
  }
}

}  // namespace
}  // namespace dualarm
