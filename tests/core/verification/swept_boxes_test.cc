#include "core/verification/swept_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/support.h"
#include "tests/core/verification/all_bodies.h"
#include "tests/core/verification/sample_motions.h"
#include "tests/support/dice.h"
#include "tests/support/exact_distance.h"

namespace dualarm {
namespace {

constexpr std::uint64_t kSeed = 72;

Eigen::Isometry3d random_pose(Dice& dice, double most) {
  const auto number = [&](double bound) { return dice.between(-bound, bound); };
  const Eigen::Vector3d axis = Eigen::Vector3d(number(1.0), number(1.0), number(1.0)).normalized();
  return Eigen::Translation3d(number(most), number(most), number(1.0)) *
         Eigen::AngleAxisd(dice.between(0.0, 3.0), axis);
}

/// Links that cross a scene of boxes that stand, are carried, and move on tracks.
struct Scene {
  Problem problem = weightless_problem({20.0, 70.0}, {60.0, 20.0}, 0.1, 0.0);
  Trajectory trajectory = parabolic_motion(problem, {0.0, 0.2});
  std::array<Interpolant, kArmCount> motions = {Interpolant(trajectory[0].knots), Interpolant(trajectory[1].knots)};
  Interval time = {0.0, trajectory[0].knots.back().time};
  CarriedBodies bodies;

  explicit Scene(std::uint64_t seed) {
    Dice dice(seed);
    for (int i = 0; i < 12; ++i) {
      const Box box = {random_pose(dice, 0.2), {dice.between(0.1, 0.5), 0.2, 0.3}};
      Object object = {"object" + std::to_string(i), box, FixedPlacement{random_pose(dice, 8.0)}};
      if (i % 3 == 1) object.placement = AttachedPlacement{i % kArmCount, random_pose(dice, 5.0), 0.0};
      if (i % 3 == 2) {
        object.placement = MovingPlacement{
            PoseTrack({{0.1, random_pose(dice, 8.0)}, {0.5, random_pose(dice, 8.0)}, {0.8, random_pose(dice, 8.0)}})};
      }
      problem.objects.push_back(object);
    }
    bodies = carried_bodies(problem, motions);
  }
};

TEST(SweptBoxes, ContainTheBodyAllTheTime) {
  Dice dice(kSeed);
  const Scene scene(kSeed);
  for (const CarriedBody* body : all_of(scene.bodies)) {
    SCOPED_TRACE(body->body.name);
    SweptBoxes boxes(*body, scene.time);
    const Eigen::AlignedBox3d before = boxes.whole();
    const std::vector<Eigen::AlignedBox3d> slices = boxes.slices();
    for (int i = 0; i < 1000; ++i) {
      const double share = dice.between(0.0, 1.0);
      const Shape shape = shape_at(*body, share * scene.time.upper);
      const Eigen::Vector3d direction(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
      const Eigen::Vector3d point = farthest_point(shape, direction);
      const Eigen::AlignedBox3d& slice =
          slices.size() > 1 ? slices[static_cast<std::size_t>(share * kSlices)] : slices.front();
      for (const Eigen::AlignedBox3d& box : {before, boxes.whole(), slice}) {
        ASSERT_LE(box.exteriorDistance(point), 1e-12) << share;
      }
    }
  }
}

TEST(SweptBoxes, NeverProveMoreThanTheSmallestDistance) {
  for (std::uint64_t seed = kSeed; seed < kSeed + 5; ++seed) {
    const Scene scene(seed);
    const std::vector<const CarriedBody*> all = all_of(scene.bodies);
    for (auto first_place = all.begin(); first_place != all.end(); ++first_place) {
      for (auto second_place = all.begin(); second_place != first_place; ++second_place) {
        const CarriedBody* first = *first_place;
        const CarriedBody* second = *second_place;
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << first->body.name << ", " << second->body.name);
        SweptBoxes firsts(*first, scene.time);
        SweptBoxes seconds(*second, scene.time);
        const double loose = distance_of_boxes(firsts, seconds, -1.0);
        const double bound = distance_of_boxes(firsts, seconds, 1e9);
        ASSERT_GE(bound, loose - 1e-12);
        for (int k = 0; k <= 20; ++k) {
          const double t = scene.time.upper * k / 20;
          const auto distance = static_cast<double>(exact_distance(shape_at(*first, t), shape_at(*second, t)));
          ASSERT_LE(bound, std::max(distance, 0.0) + 1e-12);
        }
      }
    }
  }
}

TEST(SweptBoxes, SeeThatALinkPassesAnObjectAtAnotherTime) {
  // The crate stands where the link ends, but only until the link is there: boxes of all the time meet, slices do not.
  Problem problem = weightless_problem({20.0, 70.0}, {60.0, 20.0}, 0.1, 0.0);
  const Eigen::Isometry3d there(Eigen::Translation3d(3.0, 5.1, 0.0));
  const Eigen::Isometry3d away(Eigen::Translation3d(3.0, 9.0, 0.0));
  problem.objects.push_back({"crate", Box{Eigen::Isometry3d::Identity(), {0.1, 0.1, 0.1}},
                             MovingPlacement{PoseTrack({{0.1, there}, {0.3, away}})}});
  const Trajectory trajectory = parabolic_motion(problem, {0.0, 0.2});
  const std::array<Interpolant, kArmCount> motions = {Interpolant(trajectory[0].knots),
                                                      Interpolant(trajectory[1].knots)};
  const CarriedBodies bodies = carried_bodies(problem, motions);
  const Interval time = {0.0, trajectory[0].knots.back().time};
  SweptBoxes link(bodies.moving[0][0], time);
  SweptBoxes crate(bodies.tracked[0], time);
  EXPECT_LE(distance_of_boxes(link, crate, -1.0), 0.0);
  EXPECT_GT(distance_of_boxes(link, crate, 0.5), 0.5);
}

}  // namespace
}  // namespace dualarm
