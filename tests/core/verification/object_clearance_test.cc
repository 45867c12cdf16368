// The clearance of boxes, cylinders and objects that move by themselves.
#include <gtest/gtest.h>

#include <string>

#include "core/verification/clearance_check.h"
#include "core/verification/tolerances.h"
#include "tests/core/verification/sample_motions.h"
#include "tests/support/dice.h"
#include "tests/support/independent_clearance.h"

namespace dualarm {
namespace {

constexpr double kSampleError = 1e-4;  // m, what the smallest of 4001 samples may be above the true minimum

ClearanceReport clearance_of(const Problem& problem, const Trajectory& trajectory) {
  const std::array<Interpolant, kArmCount> motions = {Interpolant(trajectory[0].knots),
                                                      Interpolant(trajectory[1].knots)};
  return check_clearance(problem, motions, trajectory[0].knots.back().time, Budget());
}

Eigen::Isometry3d pose_of(double x, double y, double yaw = 0.0) {
  return Eigen::Translation3d(x, y, 0.0) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
}

Eigen::Isometry3d any_pose(Dice& dice, double x, double y) {
  const auto number = [&](double bound) { return dice.between(-bound, bound); };
  const Eigen::Vector3d axis = Eigen::Vector3d(number(1.0), number(1.0), number(1.0)).normalized();
  return Eigen::Translation3d(x, y, number(0.3)) * Eigen::AngleAxisd(dice.between(0.0, 3.0), axis);
}

Box box_of(double x, double y, double z) { return {Eigen::Isometry3d::Identity(), {x, y, z}}; }

Cylinder upright(double radius) { return {{0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}, radius}; }

/// Arms that pass each other, with more or less of a gap.
Problem crossing_problem() { return weightless_problem({20.0, 70.0}, {60.0, 20.0}, 0.1, 0.0); }

/// Expects the proven clearance to be the sampled one, with about a hundred queries also where no more than the
/// planner's margin is left.
void expect_proof(Problem problem, const Trajectory& trajectory, const std::string& name, int most_queries) {
  SCOPED_TRACE(name);
  const SampledApproach sampled = sampled_approach(problem, trajectory, 4001);
  const ClearanceReport report = clearance_of(problem, trajectory);
  ASSERT_TRUE(report.collision_free);
  EXPECT_LE(report.min_clearance, sampled.distance);
  EXPECT_NEAR(report.min_clearance, sampled.distance, kSampleError);
  problem.options.clearance = report.min_clearance - 1e-4;
  const ClearanceReport touching = clearance_of(problem, trajectory);
  EXPECT_TRUE(touching.collision_free);
  EXPECT_LT(touching.distance_query_count, most_queries);
  problem.options.clearance = sampled.distance + 1e-5;
  const ClearanceReport closer = clearance_of(problem, trajectory);
  EXPECT_FALSE(closer.collision_free);
  ASSERT_EQ(closer.violations.size(), 1u);
  EXPECT_EQ(closer.violations[0].kind, ViolationKind::kClearance);
}

TEST(ObjectClearance, OfEveryShapeThatIsCarriedIsProven) {
  Problem problem = crossing_problem();
  const auto carry = [&](Shape shape, const Eigen::Isometry3d& pose) {
    problem.objects = {{"load", shape, AttachedPlacement{0, pose, 0.0}}};
    return parabolic_motion(problem, {0.0, 0.3});
  };
  const Trajectory with_box = carry(box_of(0.3, 0.2, 0.2), pose_of(6.0, 0.0, 0.3));
  expect_proof(problem, with_box, "box", 150);
  const Trajectory with_cylinder = carry(upright(0.3), pose_of(6.0, 0.0));
  expect_proof(problem, with_cylinder, "cylinder", 150);
  const Trajectory with_lying = carry(Cylinder{{-0.3, 0.0, 0.0}, {0.3, 0.0, 0.0}, 0.15}, pose_of(6.0, 0.0, 1.2));
  expect_proof(problem, with_lying, "lying cylinder", 150);
  const Trajectory with_plate = carry(box_of(0.3, 0.0, 0.3), pose_of(6.0, 0.1, 0.7));
  expect_proof(problem, with_plate, "plate", 150);
}

TEST(ObjectClearance, OfEveryPairOfShapesIsProven) {
  const std::vector<Shape> shapes = {Capsule{{-0.2, 0.0, 0.0}, {0.2, 0.0, 0.0}, 0.1}, box_of(0.3, 0.2, 0.1),
                                     Cylinder{{-0.1, 0.0, -0.2}, {0.1, 0.0, 0.2}, 0.2}};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t j = 0; j < shapes.size(); ++j) {
      Problem problem = crossing_problem();
      problem.objects = {{"first", shapes[i], AttachedPlacement{0, pose_of(6.0, 0.0), 0.0}},
                         {"second", shapes[j], AttachedPlacement{1, pose_of(6.0, 0.0, 0.4), 0.0}}};
      expect_proof(problem, parabolic_motion(problem, {0.0, 0.4}), std::to_string(i) + " and " + std::to_string(j),
                   200);
    }
  }
}

TEST(ObjectClearance, OfWhatStandsInTheWorldIsProven) {
  Problem problem = crossing_problem();
  const Trajectory trajectory = parabolic_motion(problem, {0.0, 0.4});
  problem.objects = {{"wall", box_of(3.0, 0.05, 2.0), FixedPlacement{pose_of(1.0, 5.4, 0.01)}}};
  expect_proof(problem, trajectory, "wall over the tip", 150);
  problem.objects = {{"post", upright(0.3), FixedPlacement{pose_of(6.1, 6.2)}}};
  expect_proof(problem, trajectory, "post beside the tip", 150);
}

TEST(ObjectClearance, OfAFloorBelowBothArmsIsProvenAtOnce) {
  Problem problem = crossing_problem();
  const Trajectory trajectory = parabolic_motion(problem, {0.0, 0.4});
  problem.objects = {
      {"floor", box_of(50.0, 50.0, 0.1), FixedPlacement{Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, -0.25))}}};
  const ClearanceReport report = clearance_of(problem, trajectory);
  EXPECT_TRUE(report.collision_free);
  EXPECT_LE(report.min_clearance, 0.05);
  EXPECT_GE(report.min_clearance, 0.05 - kClearanceShare * 0.05 - 1e-6);
  EXPECT_LT(report.distance_query_count, 20);
  problem.options.clearance = 0.051;
  EXPECT_EQ(clearance_of(problem, trajectory).violations.size(), 2u);
}

TEST(ObjectClearance, OfWhatMovesByItselfIsProven) {
  Problem problem = crossing_problem();
  const Trajectory trajectory = parabolic_motion(problem, {0.0, 0.4});
  const auto move = [&](Shape shape, std::vector<TimedPose> poses) {
    problem.objects = {{"mover", shape, MovingPlacement{PoseTrack(std::move(poses))}}};
  };
  move(box_of(0.2, 0.2, 0.2), {{0.0, pose_of(2.6, 3.2)}, {1.0, pose_of(-1.0, 4.0, 1.5)}});
  expect_proof(problem, trajectory, "box that leaves before arm 1 comes", 150);
  move(upright(0.2),
       {{0.2, pose_of(9.0, 5.0)}, {0.9, pose_of(7.2, 5.0)}, {1.0, pose_of(7.2, 5.0)}, {1.9, pose_of(6.5, 4.5)}});
  expect_proof(problem, trajectory, "drum that follows arm 2 with a rest", 150);
  Dice dice(3);
  std::vector<TimedPose> poses;
  for (int i = 0; i < 200; ++i) poses.push_back({0.01 * i, any_pose(dice, 1.0 + 0.001 * i, 5.6)});
  move(box_of(0.1, 0.2, 0.05), poses);
  expect_proof(problem, trajectory, "box that shakes beside arm 1", 400);
}

/// A box that falls on arm 1's goal from `time` (s) on.
Object box_that_passes(double time) {
  return {"mover", box_of(0.1, 0.1, 0.1),
          MovingPlacement{PoseTrack({{time, pose_of(2.0, 9.0)}, {time + 0.1, pose_of(2.0, 3.46)}})}};
}

TEST(ObjectClearance, OfWhatMovesByItselfCountsWhileItMovesAlsoBehindTheEnd) {
  Problem problem = crossing_problem();
  const Trajectory trajectory = parabolic_motion(problem, {0.0, 0.4});
  const double end = trajectory[0].knots.back().time;
  for (const double time : {end - 0.1, end, end + 100.0}) {
    SCOPED_TRACE(time);
    problem.objects = {box_that_passes(time)};
    const ClearanceReport report = clearance_of(problem, trajectory);
    EXPECT_FALSE(report.collision_free);
    ASSERT_EQ(report.violations.size(), 1u);
    EXPECT_GE(report.violations[0].time, time);
    EXPECT_EQ(report.violations[0].explanation.find("when the motion is over") != std::string::npos,
              report.violations[0].time > end);
    EXPECT_LT(report.distance_query_count, 400);
  }
}

TEST(ObjectClearance, BehindTheEndIsThatOfTheArmsThatStand) {
  Problem problem = crossing_problem();
  const Trajectory trajectory = parabolic_motion(problem, {0.0, 0.4});
  const double end = trajectory[0].knots.back().time;
  const double free = clearance_of(problem, trajectory).min_clearance;
  problem.objects = {box_that_passes(end + 1.0)};
  Trajectory moving = trajectory;
  moving[0].knots.back().velocity = 0.1;
  const ClearanceReport of_moving = clearance_of(problem, moving);
  EXPECT_TRUE(of_moving.collision_free) << "An arm that ends in motion is expected nowhere after the end.";
  EXPECT_NEAR(of_moving.min_clearance, free, 1e-2);
  problem.objects.assign(20, box_that_passes(end + 1.0));  // so many that boxes over time are asked first
  EXPECT_FALSE(clearance_of(problem, trajectory).collision_free);
  EXPECT_TRUE(clearance_of(problem, moving).collision_free);
}

TEST(ObjectClearance, BehindTheEndIsTheOneThatSamplesShow) {
  Dice dice(5);
  Problem problem = crossing_problem();
  const Trajectory trajectory = parabolic_motion(problem, {0.0, 0.4});
  const double end = trajectory[0].knots.back().time;
  for (int scene = 0; scene < 20; ++scene) {
    SCOPED_TRACE(scene);
    problem.objects = {{"mover", box_of(0.2, 0.1, 0.3),
                        MovingPlacement{PoseTrack({{end + 0.3, any_pose(dice, 2.0, 9.0)},
                                                   {end + 0.9, any_pose(dice, 2.0 + dice.between(0.0, 2.0), 6.5)},
                                                   {end + 2.0, any_pose(dice, 9.0, 9.0)}})}}};
    expect_proof(problem, trajectory, "box that passes later", 400);
  }
}

TEST(ObjectClearance, TracksWithTinyAndHugeSpansEnd) {
  Problem problem = crossing_problem();
  const Trajectory trajectory = parabolic_motion(problem, {0.0, 0.4});
  problem.objects = {{"mover", box_of(0.1, 0.1, 0.1),
                      MovingPlacement{PoseTrack({{-1e6, pose_of(20.0, 20.0)},
                                                 {0.5, pose_of(1.0, 7.0)},
                                                 {0.5 + 1e-9, pose_of(1.0, 6.5, 3.0)},
                                                 {1e6, pose_of(-20.0, 20.0)}})}}};
  EXPECT_TRUE(clearance_of(problem, trajectory).collision_free);
  problem.objects[0].placement = MovingPlacement{
      PoseTrack({{0.1, pose_of(20.0, 20.0)}, {0.1 + 1e-300, pose_of(-20.0, 20.0)}, {0.7, pose_of(-20.0, 20.0)}})};
  EXPECT_TRUE(clearance_of(problem, trajectory).collision_free);
}

TEST(ObjectClearance, OfRandomScenesIsWhatSamplesSay) {
  constexpr std::uint64_t kScenes = 120;
  int free = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Dice dice(seed);
    Problem problem = crossing_problem();
    for (int i = 0; i < 3; ++i) {
      const Shape shape = dice.happens(0.5) ? Shape(box_of(dice.between(0.05, 0.4), 0.2, 0.1))
                                            : Shape(Capsule{{-0.2, 0.0, 0.0}, {0.2, 0.0, 0.0}, 0.1});
      Object object = {"object" + std::to_string(i), shape,
                       FixedPlacement{any_pose(dice, dice.between(0.0, 8.0), dice.between(4.5, 7.0))}};
      if (dice.happens(0.3))
        object.placement = AttachedPlacement{i % 2, any_pose(dice, dice.between(1.0, 6.0), 0.0), 0.0};
      if (dice.happens(0.4)) {
        const double start = dice.between(-0.5, 1.0);
        object.placement = MovingPlacement{PoseTrack(
            {{start, any_pose(dice, dice.between(-2.0, 10.0), dice.between(2.0, 8.0))},
             {start + dice.between(0.2, 1.0), any_pose(dice, dice.between(-2.0, 10.0), dice.between(4.0, 8.0))}})};
      }
      problem.objects.push_back(object);
    }
    const Trajectory trajectory = parabolic_motion(problem, {0.0, dice.between(0.2, 0.5)});
    const SampledApproach sampled = sampled_approach(problem, trajectory, 4001);
    const ClearanceReport report = clearance_of(problem, trajectory);
    ASSERT_EQ(report.collision_free, report.violations.empty());
    if (report.collision_free) {
      ++free;
      ASSERT_LE(report.min_clearance, sampled.distance);
      ASSERT_NEAR(report.min_clearance, sampled.distance, kSampleError);
      ASSERT_LT(report.distance_query_count, 500);
    } else {
      for (const Violation& violation : report.violations) ASSERT_EQ(violation.kind, ViolationKind::kClearance);
      ASSERT_LT(sampled.distance, kSampleError);
    }
  }
  EXPECT_GT(free, 20);
  EXPECT_LT(free, 100);
}

TEST(ObjectClearance, OfAThousandFarObjectsNeedsNoQueries) {
  const auto queries_with = [](bool are_moving, int count) {
    Problem problem = crossing_problem();
    for (int i = 0; i < count; ++i) {
      const Eigen::Isometry3d pose = pose_of(10.0 + 0.01 * i, 8.0, 0.1 * i);
      Object object = {"object" + std::to_string(i), box_of(0.3, 0.2, 0.1), FixedPlacement{pose}};
      if (are_moving)
        object.placement = MovingPlacement{PoseTrack({{0.0, pose}, {1.0, pose_of(-3.0, 8.0 + 0.01 * i)}})};
      problem.objects.push_back(object);
    }
    const ClearanceReport report = clearance_of(problem, parabolic_motion(problem, {0.0, 0.4}));
    EXPECT_TRUE(report.collision_free);
    EXPECT_EQ(report.closest->first_body, "arm1");
    EXPECT_EQ(report.closest->second_body, "arm2");
    return report.distance_query_count;
  };
  const int alone = queries_with(false, 0);
  EXPECT_EQ(queries_with(false, 1000), alone);
  EXPECT_EQ(queries_with(true, 1000), alone);
}

}  // namespace
}  // namespace dualarm
