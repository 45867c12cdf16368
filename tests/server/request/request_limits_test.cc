#include "server/request/request_limits.h"

#include <gmock/gmock.h>

#include "server/request/requests.h"
#include "tests/server/paper_request.h"

namespace dualarm {
namespace {

using ::testing::HasSubstr;

template <typename Message>
std::string first_violation(const Message& message, const RequestLimits& limits) {
  const auto parsed = parse(message, limits);
  const auto* violations = std::get_if<Violations>(&parsed);
  return violations == nullptr ? "" : violations->kept()[0].field + " " + violations->kept()[0].description;
}

TEST(RequestLimits, AreTheOperators) {
  wire::PlanMotionRequest request = paper_request();
  for (const char* name : {"a", "b"}) request.mutable_scene()->add_objects()->set_name(name);
  RequestLimits limits;
  limits.objects = 1;
  EXPECT_THAT(first_violation(request, limits), HasSubstr("scene.objects has 2 entries, must have at most 1"));

  limits = {};
  limits.knots = 1;
  EXPECT_THAT(first_violation(paper_verify_request(), limits),
              HasSubstr("trajectories[0].knots.time_s has 2 entries, must have at most 1"));

  limits = {};
  limits.table_lines = 1;
  wire::PlanMotionRequest table = paper_request();
  auto& lines = *table.mutable_robot()->mutable_arms(0)->mutable_torque_limit()->mutable_table();
  lines.add_position_rad(0.0);
  lines.add_position_rad(1.0);
  lines.add_velocity_rad_per_s(0.0);
  EXPECT_THAT(first_violation(table, limits),
              HasSubstr("robot.arms[0].torque_limit.table.position_rad has 2 entries, must have 1 to 1"));
}

}  // namespace
}  // namespace dualarm
