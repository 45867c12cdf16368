#include "server/request/scene.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/server/request/violation_cases.h"

namespace dualarm {
namespace {

wire::Object& add_pillar(wire::PlanMotionRequest& request) {
  wire::Object& object = *request.mutable_scene()->add_objects();
  object.set_name("pillar");
  object.mutable_sphere()->set_radius_m(0.2);
  object.mutable_fixed()->set_x_m(4.0);
  return object;
}

wire::Object& add_load(wire::PlanMotionRequest& request) {
  wire::Object& object = *request.mutable_scene()->add_objects();
  object.set_name("load");
  object.mutable_capsule()->set_length_m(2.0);
  object.mutable_capsule()->set_radius_m(0.1);
  object.mutable_attached()->set_arm("right");
  return object;
}

TEST(ReadScene, NamesEachViolationWithItsFieldPathAndRemedy) {
  const std::vector<PlanCase> cases = {
      {"no name", [](auto& r) { add_pillar(r).clear_name(); }, "scene.objects[0].name", "is missing"},
      {"name of an arm", [](auto& r) { add_pillar(r).set_name("left"); }, "scene.objects[0].name",
       "is 'left', which another object or an arm has already"},
      {"same name",
       [](auto& r) {
         add_pillar(r);
         add_pillar(r);
       },
       "scene.objects[1].name", "is 'pillar', which"},
      {"no shape", [](auto& r) { add_pillar(r).clear_sphere(); }, "scene.objects[0].shape",
       "give a sphere or a capsule"},
      {"box", [](auto& r) { add_pillar(r).mutable_box(); }, "scene.objects[0].box", "is not served by this version"},
      {"cylinder", [](auto& r) { add_pillar(r).mutable_cylinder(); }, "scene.objects[0].cylinder",
       "is not served by this version: give a capsule"},
      {"radius", [](auto& r) { add_pillar(r).mutable_sphere()->set_radius_m(-1.0); },
       "scene.objects[0].sphere.radius_m", "is -1"},
      {"length", [](auto& r) { add_load(r).mutable_capsule()->set_length_m(kInfinity); },
       "scene.objects[0].capsule.length_m", "is inf"},
      {"no placement", [](auto& r) { add_pillar(r).clear_fixed(); }, "scene.objects[0].placement",
       "give fixed or attached"},
      {"moving", [](auto& r) { add_pillar(r).mutable_moving(); }, "scene.objects[0].moving",
       "is not served by this version"},
      {"pose NaN", [](auto& r) { add_pillar(r).mutable_fixed()->set_yaw_rad(kNan); }, "scene.objects[0].fixed.yaw_rad",
       "is nan"},
      {"mass", [](auto& r) { add_load(r).mutable_attached()->set_mass_kg(-2.0); }, "scene.objects[0].attached.mass_kg",
       "is -2"},
      {"arm", [](auto& r) { add_load(r).mutable_attached()->set_arm("middle"); }, "scene.objects[0].attached.arm",
       "is 'middle', must be 'left' or 'right'"},
      {"leaning", [](auto& r) { add_load(r).mutable_attached()->mutable_pose_in_link()->set_pitch_rad(0.1); },
       "scene.objects[0].attached.pose_in_link.pitch_rad", "not served by this version: keep the axis parallel"},
      {"too many",
       [](auto& r) {
         for (int i = 0; i < 1001; ++i) r.mutable_scene()->add_objects();
       },
       "scene.objects", "has 1001 entries, must have at most 1000"},
  };
  for (const PlanCase& expected : cases) expect_violation(paper_request(), expected);
}

TEST(ReadScene, PlacesACapsuleAlongTheXAxisOfItsPose) {
  wire::PlanMotionRequest request = paper_request();
  wire::Pose& pose = *add_load(request).mutable_attached()->mutable_pose_in_link();
  pose.set_x_m(6.0);
  pose.set_yaw_rad(std::numbers::pi / 2.0);
  const auto parsed = parse(request);
  const Problem& problem = std::get<PlanWish>(parsed).problem;
  const std::vector<Body> bodies = moving_bodies(problem, 1);
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_EQ(bodies[1].name, "load");
  EXPECT_NEAR((std::get<Capsule>(bodies[1].shape).start - Eigen::Vector3d(6.0, -1.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((std::get<Capsule>(bodies[1].shape).end - Eigen::Vector3d(6.0, 1.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(std::get<Capsule>(bodies[1].shape).radius, 0.1);
}

TEST(ReadScene, TurnsByRollThenPitchThenYaw) {
  wire::PlanMotionRequest request = paper_request();
  wire::Pose& pose = *add_pillar(request).mutable_fixed();
  pose.set_roll_rad(0.3);
  pose.set_pitch_rad(0.5);
  pose.set_yaw_rad(-0.7);
  const auto parsed = parse(request);
  const auto& placement = std::get<FixedPlacement>(std::get<PlanWish>(parsed).problem.objects[0].placement);
  // Third row of Rz Ry Rx: (-sin p, cos p sin r, cos p cos r); first column: (cos y cos p, sin y cos p, -sin p).
  EXPECT_NEAR(placement.pose.linear()(2, 0), -std::sin(0.5), 1e-15);
  EXPECT_NEAR(placement.pose.linear()(2, 1), std::cos(0.5) * std::sin(0.3), 1e-15);
  EXPECT_NEAR(placement.pose.linear()(1, 0), std::sin(-0.7) * std::cos(0.5), 1e-15);
  EXPECT_EQ(placement.pose.translation().x(), 4.0);
}

}  // namespace
}  // namespace dualarm
