#include "core/refusal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "geometry/chain.h"
#include "geometry/clearance.h"
#include "tests/support/dice.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr std::uint64_t kSeed = 71;

/// Boxes, cylinders and balls around the arms, one of four in a hand.
Problem cluttered_problem(Dice& dice) {
  Problem problem = paper_problem({dice.between(60, 120), dice.between(60, 120)}, {90, 90}, 0.1, 0.01);
  for (int i = 0; i < 12; ++i) {
    const Eigen::Vector3d axis(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), 1.0);
    const Eigen::AngleAxisd turn(dice.between(0.0, std::numbers::pi), axis.normalized());
    Shape shape = Capsule{{0, 0, 0}, {dice.between(0.0, 1.0), 0, 0}, 0.2};
    if (i % 3 == 1) shape = Box{Eigen::Isometry3d::Identity(), {0.1, 0.2, dice.between(0.0, 0.6)}};
    if (i % 3 == 2) shape = Cylinder{{0, 0, 0}, {0, 0, dice.between(0.1, 1.0)}, 0.3};
    if (dice.happens(0.25)) {
      AttachedPlacement hand;
      hand.arm = dice.one_of(kArmCount);
      hand.pose_in_link = Eigen::Translation3d(dice.between(3.0, 6.0), dice.between(-0.5, 0.5), 0.0) * turn;
      problem.objects.push_back({"load", shape, hand});
    } else {
      FixedPlacement there;
      there.pose = Eigen::Translation3d(dice.between(-4.0, 12.0), dice.between(-8.0, 8.0), 0.0) * turn;
      problem.objects.push_back({"thing", shape, there});
    }
  }
  return problem;
}

/// The same by asking for every distance.
double smallest_distance(const Problem& problem) {
  double smallest = std::numeric_limits<double>::infinity();
  const auto consider = [&](const std::vector<Body>& some, const Eigen::Isometry3d& pose,
                            const std::vector<Body>& others, const Eigen::Isometry3d& other_pose) {
    for (const Body& first : some) {
      for (const Body& second : others) {
        smallest = std::min(smallest, clearance(placed(first.shape, pose), placed(second.shape, other_pose)).distance);
      }
    }
  };
  for (const bool at_goal : {false, true}) {
    const auto pose = [&](int arm) {
      const Task& task = problem.tasks[arm];
      return link_pose(problem.arms[arm].base, (at_goal ? task.goal : task.start).position);
    };
    consider(moving_bodies(problem, 0), pose(0), moving_bodies(problem, 1), pose(1));
    for (int arm = 0; arm < kArmCount; ++arm) {
      consider(moving_bodies(problem, arm), pose(arm), fixed_bodies(problem), Eigen::Isometry3d::Identity());
    }
  }
  return smallest;
}

TEST(EndStateSlack, IsThatOfTheClosestPairOfAll) {
  SCOPED_TRACE(kSeed);
  Dice dice(kSeed);
  int apart = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    const Problem problem = cluttered_problem(dice);
    const double smallest = smallest_distance(problem);
    ASSERT_NEAR(end_state_slack(problem), smallest - problem.options.clearance, 1e-12);
    apart += smallest > 0.0 ? 1 : 0;
  }
  EXPECT_GE(apart, 30);
  EXPECT_LE(apart, 270);
}

TEST(RefuseEndStates, NamesTheClosestPairAndWhatIsMissing) {
  Problem problem = paper_problem({90, 90}, {100, 100}, 0.1, 0.05);
  Box crate;
  crate.half_extents = {0.5, 0.5, 0.5};
  FixedPlacement there;
  there.pose.translation() = Eigen::Vector3d(0.62, 3.0, 0.0);
  problem.objects = {{"crate", crate, there}};
  EXPECT_NEAR(end_state_slack(problem), 0.02 - 0.05, 1e-9);
  const Infeasible refusal = refuse_end_states(problem, 1e-4);
  EXPECT_EQ(refusal.reason, InfeasibleReason::kStartInCollision);
  EXPECT_EQ(refusal.evidence.first_body, "arm1");
  EXPECT_EQ(refusal.evidence.second_body, "crate");
  EXPECT_NEAR(refusal.evidence.depth.value(), 0.05 + 1e-4 - 0.02, 1e-9);
}

}  // namespace
}  // namespace dualarm
