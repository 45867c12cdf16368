#include "core/verification/carried_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/support.h"
#include "tests/core/verification/all_bodies.h"
#include "tests/core/verification/sample_motions.h"
#include "tests/support/dice.h"

namespace dualarm {
namespace {

constexpr std::uint64_t kSeed = 71;

Eigen::Isometry3d pose_of(const Eigen::Vector3d& at, double angle, const Eigen::Vector3d& axis) {
  return Eigen::Translation3d(at) * Eigen::AngleAxisd(angle, axis);
}

Object box_on(PoseTrack track) {
  return {"crate", Box{pose_of({0.2, 0.0, 0.1}, 0.3, Eigen::Vector3d::UnitX()), {0.5, 0.3, 0.2}},
          MovingPlacement{std::move(track)}};
}

/// A metre to the right in 0.4 s with a turn, then up.
PoseTrack bent_track() {
  return PoseTrack({{0.2, pose_of({0.0, 4.0, 0.0}, 0.9, Eigen::Vector3d::UnitX())},
                    {0.6, pose_of({1.0, 4.0, 0.0}, 1.2, Eigen::Vector3d(1.0, 2.0, 0.5).normalized())},
                    {0.9, pose_of({1.0, 4.0, 3.0}, 1.2, Eigen::Vector3d(1.0, 2.0, 0.5).normalized())}});
}

/// A problem with one object of each placement, its motion, and its bodies.
struct Scene {
  Problem problem = weightless_problem({20.0, 70.0}, {60.0, 20.0}, 0.1, 0.0);
  Trajectory trajectory;
  std::array<Interpolant, kArmCount> motions = {Interpolant({Knot{}}), Interpolant({Knot{}})};
  CarriedBodies bodies;

  Scene() {
    problem.objects.push_back(box_on(bent_track()));
    problem.objects.push_back({"post", Cylinder{{0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}, 0.3},
                               FixedPlacement{pose_of({4.0, 6.0, 0.0}, 0.0, Eigen::Vector3d::UnitX())}});
    problem.objects.push_back({"load", Box{Eigen::Isometry3d::Identity(), {0.3, 0.2, 0.1}},
                               AttachedPlacement{1, pose_of({5.0, 0.1, 0.2}, 0.4, Eigen::Vector3d::UnitY()), 0.0}});
    trajectory = parabolic_motion(problem, {0.0, 0.2});
    motions = {Interpolant(trajectory[0].knots), Interpolant(trajectory[1].knots)};
    bodies = carried_bodies(problem, motions);
  }
};

/// How far (m) the two differ in the direction.
double support_change(const Shape& from, const Shape& to, const Eigen::Vector3d& direction) {
  return std::abs(direction.dot(farthest_point(to, direction) - farthest_point(from, direction)));
}

TEST(CarriedBody, EveryObjectIsCarriedByWhatItsPlacementSays) {
  const Scene scene;
  ASSERT_EQ(scene.bodies.moving[0].size(), 1u);
  ASSERT_EQ(scene.bodies.moving[1].size(), 2u);
  EXPECT_EQ(scene.bodies.moving[1][1].body.name, "load");
  ASSERT_EQ(scene.bodies.fixed.size(), 1u);
  EXPECT_EQ(scene.bodies.fixed[0].body.name, "post");
  ASSERT_EQ(scene.bodies.tracked.size(), 1u);
  EXPECT_EQ(scene.bodies.tracked[0].body.name, "crate");
}

TEST(CarriedBody, NoPointGoesFartherThanTheBoundOfItsWay) {
  const Scene scene;
  Dice dice(kSeed);
  for (int i = 0; i < 20000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", try " << i);
    const CarriedBody& body = *all_of(scene.bodies)[static_cast<std::size_t>(dice.one_of(5))];
    const double start = dice.between(-0.1, 1.2);
    const Interval time = {start, start + (dice.happens(0.5) ? 0.02 : dice.between(0.0, 1.0))};
    const Eigen::Vector3d direction =
        Eigen::Vector3d(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0)).normalized();
    const Shape middle = shape_at(body, 0.5 * (time.lower + time.upper));
    const Shape then = shape_at(body, dice.between(time.lower, time.upper));
    ASSERT_LE(support_change(middle, then, direction), farthest_way(body, time) + 1e-12);
  }
}

TEST(CarriedBody, ATurningBodyHasTheVelocityOfTheShape) {
  const Scene scene;
  for (const CarriedBody* body : all_of(scene.bodies)) {
    for (const double time : {0.1, 0.3, 0.5, 0.7, 0.95}) {
      SCOPED_TRACE(testing::Message() << body->body.name << " at " << time << " s");
      const double half = 1e-5;
      const Interval interval = {time - half, time + half};
      ASSERT_FALSE(has_corner_inside(*body, interval));
      const TurningBody turning = turning_body(*body, interval);
      const auto expected = [&](const Shape& now, const Shape& then) {
        const Eigen::Vector3d point = centre(now);
        const Eigen::Vector3d velocity = turning.velocity + turning.rate * turning.axis.cross(point - turning.origin);
        EXPECT_NEAR((point + half * velocity - centre(then)).norm(), 0.0, 1e-8);
      };
      expected(shape_at(*body, time), shape_at(*body, time + half));
      EXPECT_GE(turning.most_rate, std::abs(turning.rate));
      EXPECT_GE(turning.extent, turning.reach);
    }
  }
}

TEST(CarriedBody, AnIntervalIsCutAtTheCornersOfATrack) {
  const Scene scene;
  const CarriedBody& crate = scene.bodies.tracked[0];
  EXPECT_TRUE(has_corner_inside(crate, {0.0, 1.0}));
  EXPECT_EQ(cut_of(crate, {0.0, 1.0}), 0.6);
  EXPECT_EQ(cut_of(crate, {0.0, 0.6}), 0.2);
  EXPECT_EQ(cut_of(crate, {0.6, 1.0}), 0.9);
  EXPECT_FALSE(has_corner_inside(crate, {0.2, 0.6}));
  EXPECT_DOUBLE_EQ(cut_of(crate, {0.2, 0.6}), 0.4);
  EXPECT_FALSE(has_corner_inside(crate, {0.9, 5.0}));
  EXPECT_FALSE(has_corner_inside(scene.bodies.moving[0][0], {0.0, 1.0}));
  EXPECT_EQ(cut_of(scene.bodies.fixed[0], {0.0, 1.0}), 0.5);
}

TEST(CarriedBody, BeforeAndAfterItsTrackABodyStandsStill) {
  const Scene scene;
  const CarriedBody& crate = scene.bodies.tracked[0];
  for (const Interval time : {Interval{0.0, 0.2}, Interval{0.9, 2.0}}) {
    const TurningBody turning = turning_body(crate, time);
    EXPECT_EQ(turning.velocity.norm(), 0.0);
    EXPECT_EQ(turning.most_rate, 0.0);
    EXPECT_EQ(farthest_way(crate, time), 0.0);
  }
}

}  // namespace
}  // namespace dualarm
