#include <gtest/gtest.h>

#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"
#include "tests/reference/motion_judge.h"
#include "tests/reference/own_equation.h"
#include "tests/reference/random_motions.h"

namespace dualarm {
namespace {

/// Of a limit, beyond which a profile's own states and accelerations count as breaking it.
constexpr double kUtilisation = 1e-9;

/// Torques, velocities and positions that the profile itself reports along its arcs.
void expect_within_limits(const Arm& arm, const Profile& profile) {
  const OwnEquation<long double> own(arm);
  constexpr int kStates = 24;
  for (const Arc& arc : profile.arcs()) {
    for (const JointState& state : profile.states_along(arc, kStates)) {
      const double acceleration = profile.acceleration_on(arc, state);
      const auto [lowest, highest] = own.torques(state.position, state.velocity);
      const long double torque = own.torque_for(state.position, state.velocity, acceleration);
      const long double slack = kUtilisation * (highest - lowest);
      ASSERT_GE(torque, lowest - slack) << "at " << state.position << ", " << state.velocity;
      ASSERT_LE(torque, highest + slack) << "at " << state.position << ", " << state.velocity;
      ASSERT_LE(state.velocity, arm.velocity.upper * (1.0 + kUtilisation)) << "at " << state.position;
      ASSERT_GE(state.velocity, arm.velocity.lower * (1.0 + kUtilisation)) << "at " << state.position;
      ASSERT_LE(state.position, arm.joint_range.upper + kUtilisation * arm.joint_range.length());
      ASSERT_GE(state.position, arm.joint_range.lower - kUtilisation * arm.joint_range.length());
    }
  }
}

class HighPrecision : public testing::TestWithParam<Family> {};

TEST_P(HighPrecision, DurationsEndsAndUtilisationsMeetALongDoubleIntegration) {
  constexpr int kProblems = 500;
  int judged = 0;
  for (int seed = 0; seed < kProblems; ++seed) {
    const MotionProblem problem = random_motion(GetParam(), 20000 + seed);
    SCOPED_TRACE(testing::Message() << "seed " << 20000 + seed << ": " << problem);
    const SingleJointArm system(problem.arm);
    // Searching swings where velocity matters takes a hundred times as long: in every tenth problem.
    const Swings swings = velocity_matters(problem.arm) && seed % 10 != 0 ? Swings::kSkip : Swings::kSearch;
    const auto answer = fastest_motion(system, problem.start, problem.goal, swings);
    const auto* motion = std::get_if<FastestMotion>(&answer);
    if (motion == nullptr || motion->profile.arcs().empty()) continue;
    ++judged;
    JudgeTolerances tolerances;
    if (velocity_matters(problem.arm)) tolerances.duration = 1e-7;
    const Profile& profile = motion->profile;
    for (const std::string& complaint :
         judge_precisely(problem.arm, problem.start, problem.goal, profile.arcs(), tolerances)) {
      ADD_FAILURE() << complaint;
    }
    EXPECT_EQ(profile.duration(), profile.arcs().back().end_time);
    expect_within_limits(problem.arm, profile);
  }
  EXPECT_GE(judged, kProblems / 2);
}

INSTANTIATE_TEST_SUITE_P(EveryFamily, HighPrecision, testing::ValuesIn(kEveryFamily),
                         [](const auto& family) { return name_of(family.param); });

}  // namespace
}  // namespace dualarm
