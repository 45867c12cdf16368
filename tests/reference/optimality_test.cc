#include <gtest/gtest.h>

#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"
#include "tests/reference/minimum_time_grid.h"
#include "tests/reference/motion_judge.h"
#include "tests/reference/random_drive.h"
#include "tests/reference/random_motions.h"

namespace dualarm {
namespace {

/// s: what the grid's own estimate of its error may be short of, as a share of the duration and beside it.
constexpr double kGridShare = 1e-6;
constexpr double kGridFloor = 1e-6;

/// The arm with a hair less torque: what it can do does not hang on the reference's mesh.
Arm weakened(Arm arm) {
  constexpr double kLeft = 1.0 - 1e-5;
  const auto shrink = [](Interval& limits) { limits = {limits.lower * kLeft, limits.upper * kLeft}; };
  if (auto* constant = std::get_if<Interval>(&arm.torque)) shrink(*constant);
  if (auto* line = std::get_if<TorqueSpeedLine>(&arm.torque)) line->stall_torque *= kLeft;
  if (auto* table = std::get_if<TorqueTable>(&arm.torque)) {
    for (Interval& limits : table->limits) shrink(limits);
  }
  return arm;
}

class FastestMotionOf : public testing::TestWithParam<Family> {};

TEST_P(FastestMotionOf, IsNeverSlowerThanTheReferenceAndNeverBlockedWhereItFindsAMotion) {
  constexpr int kProblems = 200;
  int compared = 0;
  int found = 0;
  for (int seed = 0; seed < kProblems; ++seed) {
    const MotionProblem problem = random_motion(GetParam(), seed);
    SCOPED_TRACE(testing::Message() << "seed " << seed << ": " << problem);
    const SingleJointArm system(problem.arm);
    const auto answer = fastest_motion(system, problem.start, problem.goal);
    const auto reference = minimum_time_by_grid(problem.arm, problem.start, problem.goal);
    const double slack = reference ? reference->error + kGridShare * reference->duration + kGridFloor : 0.0;
    if (const auto* blocked = std::get_if<Blocked>(&answer)) {
      if (!reference) continue;
      EXPECT_LE(blocked->lower_bound, reference->duration + slack);
      const auto sure = minimum_time_by_grid(weakened(problem.arm), problem.start, problem.goal);
      EXPECT_FALSE(sure) << "blocked for reason " << static_cast<int>(blocked->reason) << " at " << blocked->position
                         << " with " << blocked->velocity << (blocked->is_proven ? ", proven" : "")
                         << ", but the reference takes " << sure->duration << " s with " << sure->turning_points.size()
                         << " turns";
      continue;
    }
    ++found;
    const auto& motion = std::get<FastestMotion>(answer);
    const double duration = motion.profile.duration();
    EXPECT_LE(motion.lower_bound, duration * (1.0 + 1e-12));
    if (motion.minimum_over == MinimumOver::kAllMotions) {
      EXPECT_NEAR(motion.lower_bound, duration, 1e-12 * duration);
    }
    if (!reference) continue;
    ++compared;
    EXPECT_LE(duration, reference->duration + slack)
        << "the reference has " << reference->turning_points.size() << " turns, its error is " << reference->error
        << ", claimed " << static_cast<int>(motion.minimum_over);
    EXPECT_LE(motion.lower_bound, reference->duration + slack);
  }
  // A reference that finds nothing judges nothing.
  EXPECT_GE(found, kProblems / 2);
  EXPECT_GE(compared, found - found / 20);
}

TEST_P(FastestMotionOf, IsNeverSlowerThanAMotionDrivenAtRandom) {
  constexpr int kDrives = 200;
  for (int seed = 0; seed < kDrives; ++seed) {
    const MotionProblem problem = random_motion(GetParam(), 10000 + seed);
    const Drive drive = drive_at_random(problem.arm, problem.start, seed);
    SCOPED_TRACE(testing::Message() << "seed " << 10000 + seed << ": " << problem << ", driven to "
                                    << drive.end.position << ", " << drive.end.velocity << " in " << drive.duration);
    const SingleJointArm system(problem.arm);
    const auto answer = fastest_motion(system, problem.start, drive.end);
    if (const auto* blocked = std::get_if<Blocked>(&answer)) {
      ADD_FAILURE() << "blocked for reason " << static_cast<int>(blocked->reason) << " at " << blocked->position
                    << " with " << blocked->velocity << (blocked->is_proven ? ", proven" : "");
      continue;
    }
    const auto& motion = std::get<FastestMotion>(answer);
    EXPECT_LE(motion.profile.duration(), drive.duration) << static_cast<int>(motion.minimum_over);
    EXPECT_LE(motion.lower_bound, drive.duration);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryFamily, FastestMotionOf, testing::ValuesIn(kEveryFamily),
                         [](const auto& family) { return name_of(family.param); });

}  // namespace
}  // namespace dualarm
