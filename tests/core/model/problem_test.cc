#include "core/model/problem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;

Problem two_arms() {
  Problem problem;
  problem.arms[0].name = "left";
  problem.arms[1].name = "right";
  for (Arm& arm : problem.arms) {
    arm.length = 2.0;
    arm.inertia = 5.0;
    arm.gravity = paper_gravity(1.0, 2.0);
    arm.payload_gravity = 9.81;
  }
  return problem;
}

Object carried(int arm, const Eigen::Vector3d& at, double yaw, double length, double radius, double mass) {
  Eigen::Isometry3d pose = Eigen::Translation3d(at) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
  return {"load", Capsule{{-0.5 * length, 0, 0}, {0.5 * length, 0, 0}, radius}, AttachedPlacement{arm, pose, mass}};
}

/// Second moment of a capsule of even density about the z axis through the link frame's origin, by random points.
double sampled_inertia(const Capsule& capsule, double mass) {
  std::mt19937 random(3);
  const Eigen::Vector3d centre = 0.5 * (capsule.start + capsule.end);
  const double half = 0.5 * (capsule.end - capsule.start).norm() + capsule.radius;
  std::uniform_real_distribution<double> offset(-half, half);
  const Eigen::Vector3d along = capsule.end - capsule.start;
  double sum = 0.0;
  int count = 0;
  for (int i = 0; i < 2000000; ++i) {
    const Eigen::Vector3d point = centre + Eigen::Vector3d(offset(random), offset(random), offset(random));
    const double share =
        along.norm() > 0.0 ? std::clamp((point - capsule.start).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0.0;
    if ((point - capsule.start - share * along).norm() > capsule.radius) continue;
    sum += point.head<2>().squaredNorm();
    ++count;
  }
  return mass * sum / count;
}

TEST(PaperGravity, IsHalfTheWeightTimesTheLength) {
  const GravityTorque torque = paper_gravity(3.0, 2.0, 10.0);
  EXPECT_DOUBLE_EQ(torque.amplitude, 30.0);
  EXPECT_EQ(torque.phase, 0.0);
}

TEST(FieldGravity, IsTheSlopeOfThePotentialForBothSenses) {
  for (const Rotation rotation : {Rotation::kCounterclockwise, Rotation::kClockwise}) {
    Base base;
    base.heading = 0.7;
    base.rotation = rotation;
    const Eigen::Vector2d field(3.0, -9.0);
    const GravityTorque torque = field_gravity(2.0, 0.8, field, base);
    const auto potential = [&](double theta) {
      const double direction = base.heading + base.sense() * theta;
      return -2.0 * 0.8 * field.dot(Eigen::Vector2d(std::cos(direction), std::sin(direction)));
    };
    for (double theta = -3.0; theta < 3.0; theta += 0.1) {
      const double slope = (potential(theta + 1e-5) - potential(theta - 1e-5)) / 2e-5;
      EXPECT_NEAR(torque.amplitude * std::sin(theta - torque.phase), slope, 1e-6);
    }
  }
}

TEST(MovingBodies, AreTheLinkAndWhatTheArmCarries) {
  Problem problem = two_arms();
  problem.objects = {carried(1, {2.0, 0.5, 0.0}, 0.5 * kPi, 1.0, 0.1, 3.0)};
  EXPECT_EQ(moving_bodies(problem, 0).size(), 1U);
  const std::vector<Body> bodies = moving_bodies(problem, 1);
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_EQ(bodies[1].name, "load");
  EXPECT_TRUE(std::get<Capsule>(bodies[1].shape).start.isApprox(Eigen::Vector3d(2.0, 0.0, 0.0)));
  EXPECT_TRUE(std::get<Capsule>(bodies[1].shape).end.isApprox(Eigen::Vector3d(2.0, 1.0, 0.0)));
  EXPECT_TRUE(fixed_bodies(problem).empty());
}

TEST(FixedAndTrackedBodies, AreTheObjectsThatNoArmCarries) {
  Problem problem = two_arms();
  Box box;
  box.half_extents = {0.1, 0.2, 0.3};
  FixedPlacement there;
  there.pose = Eigen::Translation3d(1.0, 2.0, 3.0) * Eigen::AngleAxisd(0.5 * kPi, Eigen::Vector3d::UnitZ());
  MovingPlacement door;
  door.track = PoseTrack({{0.0, Eigen::Isometry3d::Identity()}, {1.0, there.pose}});
  problem.objects = {{"door", box, door}, carried(0, {2.0, 0.0, 0.0}, 0.0, 1.0, 0.1, 3.0), {"crate", box, there}};
  const std::vector<Body> fixed = fixed_bodies(problem);
  ASSERT_EQ(fixed.size(), 1U);
  EXPECT_EQ(fixed[0].name, "crate");
  EXPECT_TRUE(std::get<Box>(fixed[0].shape).pose.isApprox(there.pose));
  const std::vector<TrackedBody> tracked = tracked_bodies(problem);
  ASSERT_EQ(tracked.size(), 1U);
  EXPECT_EQ(tracked[0].body.name, "door");
  EXPECT_TRUE(tracked[0].track->pose_at(2.0).isApprox(there.pose));
  EXPECT_EQ(tracked[0].track, &std::get<MovingPlacement>(problem.objects[0].placement).track);
}

TEST(LoadedArm, IsTheArmItselfWithoutLoad) {
  const Problem problem = two_arms();
  EXPECT_EQ(loaded_arm(problem, 0).inertia, 5.0);
  EXPECT_EQ(loaded_arm(problem, 0).gravity.amplitude, problem.arms[0].gravity.amplitude);
}

TEST(LoadedArm, AddsTheInertiaOfTheSolidThatItCarries) {
  for (const auto& [length, radius] : {std::pair{1.0, 0.4}, {0.0, 0.5}, {1.5, 0.05}}) {
    Problem problem = two_arms();
    problem.objects = {carried(0, {1.8, 0.3, 0.0}, 0.9, length, radius, 4.0)};
    const double expected = sampled_inertia(std::get<Capsule>(moving_bodies(problem, 0)[1].shape), 4.0);
    EXPECT_NEAR(loaded_arm(problem, 0).inertia - 5.0, expected, 0.005 * expected) << length << " " << radius;
  }
}

TEST(LoadedArm, AddsTheTorqueOfTheLoadsWeightWhereItsCentreIs) {
  for (const Rotation rotation : {Rotation::kCounterclockwise, Rotation::kClockwise}) {
    Problem problem = two_arms();
    Arm& arm = problem.arms[0];
    arm.base.rotation = rotation;
    const Eigen::Vector2d field(0.0, -9.81);
    arm.gravity = field_gravity(1.0, 1.0, field, arm.base);
    arm.payload_gravity_phase = arm.gravity.phase;
    problem.objects = {carried(0, {1.5, 0.7, 0.0}, 0.0, 0.4, 0.1, 3.0)};
    const Arm loaded = loaded_arm(problem, 0);
    const auto potential = [&](double theta) {
      const Eigen::Isometry3d pose = link_pose(arm.base, theta);
      const Eigen::Vector3d own = pose * Eigen::Vector3d(1.0, 0.0, 0.0);
      const Eigen::Vector3d load = pose * Eigen::Vector3d(1.5, 0.7, 0.0);
      return -field.dot(own.head<2>()) - 3.0 * field.dot(load.head<2>());
    };
    for (double theta = -3.0; theta < 3.0; theta += 0.1) {
      const double slope = (potential(theta + 1e-5) - potential(theta - 1e-5)) / 2e-5;
      EXPECT_NEAR(loaded.gravity.amplitude * std::sin(theta - loaded.gravity.phase), slope, 1e-5);
    }
  }
}

TEST(LoadedArm, KeepsItsFrictionAndItsTorqueLimits) {
  Problem problem = two_arms();
  problem.arms[0].viscous_friction = 2.5;
  problem.arms[0].torque = TorqueSpeedLine{60.0, 3.0};
  problem.objects = {carried(0, {1.8, 0.3, 0.0}, 0.9, 1.0, 0.1, 4.0)};
  EXPECT_EQ(loaded_arm(problem, 0).viscous_friction, 2.5);
  EXPECT_EQ(loaded_arm(problem, 0).torque, problem.arms[0].torque);
}

TEST(PlanOptions, AllowEveryMethodUnlessSomeAreNamed) {
  PlanOptions options;
  EXPECT_TRUE(options.allows(Method::kStateTime));
  options.methods = {Method::kDelay};
  EXPECT_TRUE(options.allows(Method::kDelay));
  EXPECT_FALSE(options.allows(Method::kStateTime));
}

}  // namespace
}  // namespace dualarm
