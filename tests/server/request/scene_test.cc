#include "server/request/scene.h"

#include <gtest/gtest.h>

#include <cmath>
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

wire::TimedPose& add_pose(wire::Object& object, double time, double x, double yaw = 0.0) {
  wire::TimedPose& timed = *object.mutable_moving()->add_poses();
  timed.set_time_s(time);
  timed.mutable_pose()->set_x_m(x);
  timed.mutable_pose()->set_yaw_rad(yaw);
  return timed;
}

/// A workpiece that passes below both arms in a second.
wire::Object& add_workpiece(wire::PlanMotionRequest& request) {
  wire::Object& object = *request.mutable_scene()->add_objects();
  object.set_name("workpiece");
  object.mutable_box()->set_size_x_m(0.4);
  object.mutable_box()->set_size_y_m(0.3);
  object.mutable_box()->set_size_z_m(0.2);
  add_pose(object, 0.5, -3.0);
  add_pose(object, 1.5, 11.0, 1.0);
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
       "give a sphere, a capsule, a box or a cylinder"},
      {"box", [](auto& r) { add_workpiece(r).mutable_box()->set_size_y_m(-0.1); }, "scene.objects[0].box.size_y_m",
       "is -0.1, must be 0 to 10000 m"},
      {"cylinder", [](auto& r) { add_pillar(r).mutable_cylinder()->set_length_m(-1.0); },
       "scene.objects[0].cylinder.length_m", "is -1, must be 1e-06 to 10000 m"},
      {"disc", [](auto& r) { add_pillar(r).mutable_cylinder()->set_radius_m(0.5); },
       "scene.objects[0].cylinder.length_m", "is 0, must be 1e-06 to 10000 m: a disc needs some thickness"},
      {"radius", [](auto& r) { add_pillar(r).mutable_sphere()->set_radius_m(-1.0); },
       "scene.objects[0].sphere.radius_m", "is -1"},
      {"length", [](auto& r) { add_load(r).mutable_capsule()->set_length_m(kInfinity); },
       "scene.objects[0].capsule.length_m", "is inf"},
      {"no placement", [](auto& r) { add_pillar(r).clear_fixed(); }, "scene.objects[0].placement",
       "give fixed, attached or moving"},
      {"no track", [](auto& r) { add_pillar(r).mutable_moving(); }, "scene.objects[0].moving.poses",
       "is missing: give at least one"},
      {"no pose", [](auto& r) { add_workpiece(r).mutable_moving()->mutable_poses(1)->clear_pose(); },
       "scene.objects[0].moving.poses[1].pose", "is missing: give the object's pose"},
      {"far pose", [](auto& r) { add_pose(add_workpiece(r), 2.0, 10001.0); },
       "scene.objects[0].moving.poses[2].pose.x_m", "is 10001, must be -10000 to 10000 m"},
      {"time NaN", [](auto& r) { add_workpiece(r).mutable_moving()->mutable_poses(0)->set_time_s(kNan); },
       "scene.objects[0].moving.poses[0].time_s", "is nan"},
      {"time beyond", [](auto& r) { add_pose(add_workpiece(r), 2e6, 0.0); }, "scene.objects[0].moving.poses[2].time_s",
       "is 2000000, must be -1000000 to 1000000 s"},
      {"same time", [](auto& r) { add_pose(add_workpiece(r), 1.5, 12.0); }, "scene.objects[0].moving.poses[2].time_s",
       "is 1.5 s, must be at least 1e-06 s after the pose before, which is at 1.5 s"},
      {"earlier", [](auto& r) { add_pose(add_workpiece(r), 1.0, 12.0); }, "scene.objects[0].moving.poses[2].time_s",
       "is 1 s, must be at least"},
      {"half a turn", [](auto& r) { add_pose(add_workpiece(r), 2.0, 12.0, 1.0 - std::numbers::pi); },
       "scene.objects[0].moving.poses[2].pose", "has no shorter way round, give a pose in between"},
      {"too many poses",
       [](auto& r) {
         wire::Object& object = add_workpiece(r);
         for (int i = 0; i < 9999; ++i) add_pose(object, 2.0 + i, 0.0);
       },
       "scene.objects[0].moving.poses", "has 10001 entries, must have at most 10000"},
      {"pose NaN", [](auto& r) { add_pillar(r).mutable_fixed()->set_yaw_rad(kNan); }, "scene.objects[0].fixed.yaw_rad",
       "is nan"},
      {"mass", [](auto& r) { add_load(r).mutable_attached()->set_mass_kg(-2.0); }, "scene.objects[0].attached.mass_kg",
       "is -2"},
      {"arm", [](auto& r) { add_load(r).mutable_attached()->set_arm("middle"); }, "scene.objects[0].attached.arm",
       "is 'middle', must be 'left' or 'right'"},
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

/// The objects of a request that must be sound.
std::vector<Object> objects_of(const wire::PlanMotionRequest& request) {
  const auto parsed = parse(request);
  return std::get<PlanWish>(parsed).problem.objects;
}

TEST(ReadScene, PlacesACapsuleThatLeans) {
  wire::PlanMotionRequest request = paper_request();
  add_load(request).mutable_attached()->mutable_pose_in_link()->set_pitch_rad(0.1);
  const AttachedPlacement placement = std::get<AttachedPlacement>(objects_of(request)[0].placement);
  EXPECT_NEAR(placement.pose_in_link.linear()(2, 0), -std::sin(0.1), 1e-15);
}

TEST(ReadScene, ReadsABoxByItsEdgesAndACylinderAlongItsXAxis) {
  wire::PlanMotionRequest request = paper_request();
  add_workpiece(request);
  wire::Object& post = add_pillar(request);
  post.mutable_cylinder()->set_length_m(3.0);
  post.mutable_cylinder()->set_radius_m(0.25);
  const std::vector<Object> objects = objects_of(request);
  const Box box = std::get<Box>(objects[0].shape);
  EXPECT_EQ(box.half_extents, Eigen::Vector3d(0.2, 0.15, 0.1));
  EXPECT_TRUE(box.pose.isApprox(Eigen::Isometry3d::Identity()));
  const Cylinder cylinder = std::get<Cylinder>(objects[1].shape);
  EXPECT_EQ(cylinder.start, Eigen::Vector3d(-1.5, 0.0, 0.0));
  EXPECT_EQ(cylinder.end, Eigen::Vector3d(1.5, 0.0, 0.0));
  EXPECT_EQ(cylinder.radius, 0.25);
}

TEST(ReadScene, ReadsATrackInOrderOfTime) {
  wire::PlanMotionRequest request = paper_request();
  add_pose(add_workpiece(request), 1.6, 11.0, 4.0);
  const PoseTrack track = std::get<MovingPlacement>(objects_of(request)[0].placement).track;
  ASSERT_EQ(track.poses().size(), 3u);
  EXPECT_EQ(track.begin_time(), 0.5);
  EXPECT_EQ(track.end_time(), 1.6);
  EXPECT_NEAR(track.pose_at(1.0).translation().x(), 4.0, 1e-12);
  EXPECT_NEAR(track.pose_at(1.0).linear()(1, 0), std::sin(0.5), 1e-12);
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
