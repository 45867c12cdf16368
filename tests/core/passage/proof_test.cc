#include "core/passage/proof.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/passage/relaxed_arm.h"
#include "core/phase_plane/minimum.h"
#include "core/systems/single_joint_arm.h"
#include "tests/core/passage/scene_travellers.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

TEST(PassageProof, IsTheBoundItselfForShortMotionsOfStrongArms) {
  const Problem problem = paper_problem({5, 60}, {50, 10});
  EXPECT_NEAR(passage_proof(problem, 0.0, 3.0, Budget()).duration, 2.08796, 1e-5);
}

TEST(PassageProof, NeverSaysMoreThanItLookedAt) {
  const PassageProof proof = passage_proof(paper_problem({5, 60}, {50, 10}), 0.0, 1.5, Budget());
  EXPECT_LE(proof.duration, 1.5);
  EXPECT_GT(proof.duration, 1.4);
}

TEST(PassageProof, IsWeakerForDrivesThatSpeedWeakens) {
  Problem problem = paper_problem({5, 60}, {50, 10});
  const double constant = passage_proof(problem, 0.0, 3.0, Budget()).duration;
  for (Arm& arm : problem.arms) arm.torque = TorqueSpeedLine{60.0, 6.0};
  // The stall torque everywhere is the relaxed drive: it gives the constant limits' bound.
  EXPECT_NEAR(passage_proof(problem, 0.0, 3.0, Budget()).duration, constant, 1e-6);
  for (Arm& arm : problem.arms) arm.viscous_friction = 2.0;
  const double with_friction = passage_proof(problem, 0.0, 3.0, Budget()).duration;
  EXPECT_LT(with_friction, constant);
  EXPECT_GT(with_friction, 0.9 * constant);
}

TEST(PassageProof, IsNothingForFrictionWithoutEnd) {
  Problem problem = paper_problem({5, 60}, {50, 10});
  problem.arms[0].viscous_friction = 1.0;
  problem.arms[0].velocity = {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  EXPECT_EQ(passage_proof(problem, 0.0, 3.0, Budget()).duration, 0.0);
}

TEST(Reachable, GrowsWithTheDurationAndHoldsTheWay) {
  const Problem problem = paper_problem({20, 90}, {70, 60});
  Interval before = {in_radians(20.0), in_radians(70.0)};
  for (const double duration : {1.2, 1.5, 2.0, 8.0}) {
    const Interval reached = reachable(problem.arms[0], problem.tasks[0], duration);
    EXPECT_LE(reached.lower, before.lower);
    EXPECT_GE(reached.upper, before.upper);
    before = reached;
  }
  EXPECT_EQ(before, problem.arms[0].joint_range);
}

TEST(RelaxedArm, IsTheArmItselfWhereItIsStrongWithinReach) {
  Problem problem = paper_problem({10, 90}, {40, 60});
  problem.arms[0].torque = Interval{-25.0, 25.0};  // less than gravity's 29.43 N m at 90 degrees
  EXPECT_FALSE(is_strong(SingleJointArm(problem.arms[0])));
  const auto near = relaxed_arm(problem.arms[0], problem.tasks[0], 1.3);
  ASSERT_TRUE(near);
  EXPECT_EQ(near->torque, problem.arms[0].torque);
  const auto far = relaxed_arm(problem.arms[0], problem.tasks[0], 4.0);
  ASSERT_TRUE(far);
  EXPECT_NE(far->torque, problem.arms[0].torque);
  EXPECT_GT(complete_until(*far), 0.0);
}

TEST(RelaxedArm, BrakesWithFrictionsHelpInBothDirections) {
  Problem problem = paper_problem({10, 90}, {40, 60});
  problem.arms[0].viscous_friction = 3.0;
  problem.arms[0].velocity = {-1.0, 2.0};
  const auto relaxed = relaxed_arm(problem.arms[0], problem.tasks[0], 2.0);
  ASSERT_TRUE(relaxed);
  EXPECT_EQ(std::get<Interval>(relaxed->torque), (Interval{-66.0, 63.0}));
  EXPECT_EQ(relaxed->viscous_friction, 0.0);
}

TEST(CompleteUntil, CountsGravitysSlopeInsideTheRangeOnly) {
  Arm arm = paper_problem({10, 90}, {40, 60}).arms[0];
  const double stiffness = 29.43 / 39.0;
  EXPECT_NEAR(complete_until(arm), std::numbers::pi / std::sqrt(stiffness), 1e-6);
  arm.joint_range = {in_radians(60.0), in_radians(90.0)};
  EXPECT_NEAR(complete_until(arm), std::numbers::pi / std::sqrt(0.5 * stiffness), 1e-6);
  arm.joint_range = {in_radians(100.0), in_radians(120.0)};
  EXPECT_TRUE(std::isinf(complete_until(arm)));
}

TEST(PassageProof, LosesNothingWhereItBeginsAtTheGateOfAWiderSet) {
  for (const auto& [start, goal] : {std::pair{std::array{5.0, 60.0}, std::array{50.0, 10.0}},
                                    {std::array{10.0, 40.0}, std::array{40.0, 10.0}},
                                    {std::array{20.0, 70.0}, std::array{60.0, 20.0}},
                                    {std::array{30.0, 60.0}, std::array{60.0, 30.0}}}) {
    const Problem problem = paper_problem(start, goal, 1e-3);
    const SceneTravellers scene(problem);
    const PassageBound wider = passage_bound(ForbiddenPlane(problem, 1e-4), scene.travellers, Budget());
    const double cold = passage_proof(problem, 0.0, wider.duration, Budget()).duration;
    const double begun = passage_proof(problem, 0.0, wider.duration, Budget(), wider.ways).duration;
    EXPECT_GT(begun, cold * (1.0 - 1e-8));
    EXPECT_LE(begun, wider.duration);
  }
}

}  // namespace
}  // namespace dualarm
