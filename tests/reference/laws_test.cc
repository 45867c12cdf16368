#include <gtest/gtest.h>

#include <limits>

#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"
#include "tests/reference/random_drive.h"
#include "tests/reference/random_motions.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Where velocity matters a search takes a hundred times as long.
constexpr int kProblems = 60;
constexpr int kSlowProblems = 12;
/// Of a duration: what a law may miss where both sides are computed in closed form or by quadrature; where turning
/// points were searched, whose position the duration hardly depends on; and where arcs were integrated.
constexpr double kExact = 1e-9;
constexpr double kSearched = 1e-8;
constexpr double kIntegrated = 1e-7;

int problems_of(Family family) {
  const bool slow = family == Family::kTorqueSpeed || family == Family::kTable || family == Family::kFriction ||
                    family == Family::kMixed;
  return slow ? kSlowProblems : kProblems;
}

struct Solved {
  double seconds = kInfinity;  ///< infinite where the motion is blocked
  double slack = 0.0;          ///< s
};

Solved solve(const MotionProblem& problem) {
  const SingleJointArm system(problem.arm);
  const auto answer = fastest_motion(system, problem.start, problem.goal);
  const auto* motion = std::get_if<FastestMotion>(&answer);
  if (motion == nullptr) return {};
  const bool searched = motion->minimum_over != MinimumOver::kAllMotions;
  const double share = velocity_matters(problem.arm) ? kIntegrated : searched ? kSearched : kExact;
  return {motion->profile.duration(), share * motion->profile.duration()};
}

double duration(const MotionProblem& problem) { return solve(problem).seconds; }

void scale(TorqueLimit& limit, double torque, double velocity) {
  const auto scaled = [&](Interval limits) { return Interval{limits.lower * torque, limits.upper * torque}; };
  if (auto* constant = std::get_if<Interval>(&limit)) *constant = scaled(*constant);
  if (auto* line = std::get_if<TorqueSpeedLine>(&limit)) {
    *line = {line->stall_torque * torque, line->no_load_speed * velocity};
  }
  if (auto* table = std::get_if<TorqueTable>(&limit)) {
    for (double& at : table->velocities) at *= velocity;
    for (Interval& limits : table->limits) limits = scaled(limits);
  }
}

Interval turned(Interval interval) { return {-interval.upper, -interval.lower}; }

class LawsOf : public testing::TestWithParam<Family> {
 protected:
  /// Calls `law(problem, solved)` with random problems and their answers; at least a third of them has a motion.
  template <typename Law>
  void hold(const Law& law) const {
    int moving = 0;
    const int problems = problems_of(GetParam());
    for (int seed = 30000; seed < 30000 + problems; ++seed) {
      const MotionProblem problem = random_motion(GetParam(), seed);
      SCOPED_TRACE(testing::Message() << "seed " << seed << ": " << problem);
      const Solved solved = solve(problem);
      if (solved.seconds < kInfinity) ++moving;
      law(problem, solved);
    }
    EXPECT_GE(moving, problems / 3);
  }

  static void expect_same(double seconds, const Solved& expected) {
    if (expected.seconds == kInfinity) {
      EXPECT_EQ(seconds, kInfinity);
    } else {
      EXPECT_NEAR(seconds, expected.seconds, expected.slack);
    }
  }
};

TEST_P(LawsOf, TheMotionBackTakesAsLongWhereVelocityDoesNotMatter) {
  hold([&](const MotionProblem& problem, const Solved& solved) {
    if (velocity_matters(problem.arm)) return;
    MotionProblem back = problem;
    back.start = {problem.goal.position, -problem.goal.velocity};
    back.goal = {problem.start.position, -problem.start.velocity};
    back.arm.velocity = turned(problem.arm.velocity);
    expect_same(duration(back), solved);
  });
}

TEST_P(LawsOf, TheMirroredArmTakesAsLong) {
  hold([&](const MotionProblem& problem, const Solved& solved) {
    MotionProblem mirrored = problem;
    mirrored.start = {-problem.start.position, -problem.start.velocity};
    mirrored.goal = {-problem.goal.position, -problem.goal.velocity};
    Arm& arm = mirrored.arm;
    arm.gravity.phase = -arm.gravity.phase;
    arm.joint_range = turned(arm.joint_range);
    arm.velocity = turned(arm.velocity);
    if (auto* constant = std::get_if<Interval>(&arm.torque)) *constant = turned(*constant);
    if (auto* table = std::get_if<TorqueTable>(&arm.torque)) {
      for (auto* lines : {&table->positions, &table->velocities}) {
        std::reverse(lines->begin(), lines->end());
        for (double& line : *lines) line = -line;
      }
      std::reverse(table->limits.begin(), table->limits.end());
      for (Interval& limits : table->limits) limits = turned(limits);
    }
    expect_same(duration(mirrored), solved);
  });
}

TEST_P(LawsOf, ASlowerClockShowsTheSameMotion) {
  hold([&](const MotionProblem& problem, const Solved& solved) {
    for (const double slower : {2.0, 1.7}) {
      MotionProblem slow = problem;
      slow.start.velocity /= slower;
      slow.goal.velocity /= slower;
      slow.arm.velocity = {slow.arm.velocity.lower / slower, slow.arm.velocity.upper / slower};
      slow.arm.gravity.amplitude /= slower * slower;
      slow.arm.viscous_friction /= slower;
      scale(slow.arm.torque, 1.0 / (slower * slower), 1.0 / slower);
      expect_same(duration(slow) / slower, solved);
    }
  });
}

TEST_P(LawsOf, AHeavierArmWithAStrongerDriveMovesTheSame) {
  hold([&](const MotionProblem& problem, const Solved& solved) {
    constexpr double kHeavier = 3.7;
    MotionProblem heavy = problem;
    heavy.arm.inertia *= kHeavier;
    heavy.arm.gravity.amplitude *= kHeavier;
    heavy.arm.viscous_friction *= kHeavier;
    scale(heavy.arm.torque, kHeavier, 1.0);
    expect_same(duration(heavy), solved);
  });
}

TEST_P(LawsOf, MoreTorqueIsNeverSlower) {
  hold([&](const MotionProblem& problem, const Solved& solved) {
    for (const double more : {1.01, 1.5}) {
      MotionProblem strong = problem;
      scale(strong.arm.torque, more, 1.0);
      EXPECT_LE(duration(strong), solved.seconds + solved.slack) << more;
    }
  });
}

TEST_P(LawsOf, AWiderRangeAndFasterLimitsAreNeverSlower) {
  hold([&](const MotionProblem& problem, const Solved& solved) {
    for (const double more : {0.01, 0.7}) {
      MotionProblem wide = problem;
      wide.arm.joint_range = {problem.arm.joint_range.lower - more, problem.arm.joint_range.upper + more};
      EXPECT_LE(duration(wide), solved.seconds + solved.slack) << "range " << more;
      MotionProblem fast = problem;
      fast.arm.velocity = {problem.arm.velocity.lower - more, problem.arm.velocity.upper + more};
      EXPECT_LE(duration(fast), solved.seconds + solved.slack) << "velocity " << more;
    }
  });
}

TEST_P(LawsOf, NoDetourThroughAReachableStateIsFaster) {
  for (int seed = 40000; seed < 40000 + problems_of(GetParam()); ++seed) {
    MotionProblem problem = random_motion(GetParam(), seed);
    const JointState via = drive_at_random(problem.arm, problem.start, seed).end;
    problem.goal = drive_at_random(problem.arm, via, seed + 1).end;
    SCOPED_TRACE(testing::Message() << "seed " << seed << ": " << problem << " via " << via.position << ", "
                                    << via.velocity);
    MotionProblem first = problem;
    first.goal = via;
    MotionProblem second = problem;
    second.start = via;
    const Solved to_via = solve(first);
    const Solved onwards = solve(second);
    ASSERT_LT(to_via.seconds + onwards.seconds, kInfinity);
    EXPECT_LE(duration(problem), to_via.seconds + onwards.seconds + to_via.slack + onwards.slack);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryFamily, LawsOf, testing::ValuesIn(kEveryFamily),
                         [](const auto& family) { return name_of(family.param); });

}  // namespace
}  // namespace dualarm
