#include "core/verification/torque_peak.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

#include "core/verification/limit_check.h"
#include "core/verification/tolerances.h"
#include "tests/core/verification/sample_motions.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

LimitReport limits_of(const Arm& arm, const std::vector<Knot>& knots) {
  const Interpolant motion(knots);
  const JointTorque torque(arm);
  return check_limits(arm, torque, NeededTorque(torque, motion), motion, Budget());
}

/// A drive that fades with speed and is weaker in some places than in others, differently up and down.
TorqueTable uneven_table() {
  return {{0.3, 0.6, 1.1, 1.7},
          {-2.0, -0.5, 0.2, 0.9, 2.5},
          {{-40.0, 75.0}, {-60.0, 70.0}, {-62.0, 66.0}, {-64.0, 60.0}, {-70.0, 45.0}, {-38.0, 70.0}, {-55.0, 66.0},
           {-58.0, 61.0}, {-60.0, 58.0}, {-66.0, 40.0}, {-45.0, 80.0}, {-59.0, 75.0}, {-63.0, 72.0}, {-66.0, 64.0},
           {-72.0, 48.0}, {-42.0, 72.0}, {-57.0, 69.0}, {-60.0, 63.0}, {-63.0, 59.0}, {-69.0, 44.0}}};
}

struct Drive {
  const char* name;
  TorqueLimit limit;
  double friction;  // N m s
};

std::vector<Drive> changing_drives() {
  const TorqueTable by_position = {{0.4, 0.7, 1.2}, {0.0}, {{-70.0, 70.0}, {-55.0, 62.0}, {-66.0, 75.0}}};
  const TorqueTable by_velocity = {{0.0}, {-1.0, 0.25, 1.0}, {{-45.0, 75.0}, {-60.0, 66.0}, {-70.0, 50.0}}};
  return {{"torque-speed line", TorqueSpeedLine{80.0, 3.0}, 0.0},
          {"torque-speed line, friction", TorqueSpeedLine{80.0, 2.0}, 5.0},
          {"table over positions", by_position, 0.0},
          {"table over velocities", by_velocity, 3.0},
          {"table over both", uneven_table(), 4.0}};
}

Problem problem_with(const TorqueLimit& limit, double friction) {
  Problem problem = paper_problem({30.0, 120.0}, {30.0, 120.0});
  Arm& arm = problem.arms[0];
  arm.gravity.phase = -0.3;
  arm.torque = limit;
  arm.viscous_friction = friction;
  arm.velocity = {-kInfinity, kInfinity};
  arm.joint_range = {-4.0, 4.0};
  return problem;
}

const std::vector<Stretch>& up_down_up() {
  static const std::vector<Stretch> kStretches = {
      {Effort::kUpward, 1.1}, {Effort::kDownward, 1.9}, {Effort::kUpward, 0.7}};
  return kStretches;
}

TEST(TorquePeak, MotionsOnTheLimitThatTurnBackAreAtOneAndNotAbove) {
  for (const Drive& drive : changing_drives()) {
    for (const double period : {0.002, 0.01}) {
      for (const double velocity : {0.0, -0.6}) {
        SCOPED_TRACE(testing::Message() << drive.name << ", knots " << period << " s, from " << velocity << " rad/s");
        Problem problem = problem_with(drive.limit, drive.friction);
        problem.tasks[0].start.velocity = velocity;
        const Trajectory trajectory = driven_motion(problem, up_down_up(), period);
        const LimitReport report = limits_of(problem.arms[0], trajectory[0].knots);
        for (const Violation& violation : report.violations) ADD_FAILURE() << violation.explanation;
        EXPECT_GE(report.torque.value, 1.0);
        EXPECT_LE(report.torque.value, 1.0 + 1e-9);
      }
    }
  }
}

TEST(TorquePeak, ConstantLimitsWithFrictionAreRiddenToo) {
  Problem problem = problem_with(Interval{-55.0, 70.0}, 8.0);
  const Trajectory trajectory = driven_motion(problem, up_down_up(), 0.005);
  const LimitReport report = limits_of(problem.arms[0], trajectory[0].knots);
  EXPECT_THAT(report.violations, IsEmpty());
  EXPECT_NEAR(report.torque.value, 1.0, 1e-6);
}

TEST(TorquePeak, ADriveUsedToNineTenthsIsAtNineTenths) {
  for (const Drive& drive : changing_drives()) {
    SCOPED_TRACE(drive.name);
    TorqueLimit weaker = drive.limit;
    if (auto* line = std::get_if<TorqueSpeedLine>(&weaker)) line->stall_torque *= 0.9;
    if (auto* table = std::get_if<TorqueTable>(&weaker)) {
      for (Interval& limits : table->limits) limits = {0.9 * limits.lower, 0.9 * limits.upper};
    }
    Problem problem = problem_with(weaker, drive.friction);
    const Trajectory trajectory = driven_motion(problem, up_down_up(), 0.005);
    problem.arms[0].torque = drive.limit;
    EXPECT_NEAR(limits_of(problem.arms[0], trajectory[0].knots).torque.value, 0.9, 1e-9);
  }
}

TEST(TorquePeak, AQuinticAcrossABendThatItsTorqueFollowsIsAboveTheLimitThere) {
  const TorqueTable notch = {{0.9, 1.0, 1.1}, {0.0}, {{-70.0, 70.0}, {-70.0, 50.0}, {-70.0, 70.0}}};
  Problem with_knots = problem_with(notch, 0.0);
  const Trajectory honest = driven_motion(with_knots, {{Effort::kUpward, 1.0}}, 0.02);
  EXPECT_THAT(limits_of(with_knots.arms[0], honest[0].knots).violations, IsEmpty());
  Problem without = problem_with(notch, 0.0);
  const Trajectory smoothed = driven_motion(without, {{Effort::kUpward, 1.0}}, 0.02, false);
  const LimitReport report = limits_of(without.arms[0], smoothed[0].knots);
  ASSERT_EQ(report.violations.size(), 1u);
  EXPECT_EQ(report.violations[0].kind, ViolationKind::kTorque);
  EXPECT_GT(report.torque.value, 1.001);
}

TEST(TorquePeak, TheLimitsAreNamedAsTheyAreInThatState) {
  const TorqueTable table = {{0.0, 2.0}, {0.0}, {{-80.0, 80.0}, {-40.0, 40.0}}};
  Problem problem = problem_with(table, 0.0);
  problem.arms[0].gravity = {};
  // From 1 rad with 2 rad/s2: 78 N m, where the drive gives 60, and less and less.
  const LimitReport report = limits_of(problem.arms[0], {{0.0, 1.0, 0.0, 2.0, 78.0}, {0.5, 1.25, 1.0, 2.0, 78.0}});
  ASSERT_EQ(report.violations.size(), 1u);
  EXPECT_NEAR(report.violations[0].value, 78.0, 1e-6);
  EXPECT_NEAR(report.violations[0].limit, 55.0, 1e-6);
  EXPECT_THAT(report.violations[0].explanation, HasSubstr("its limits are -55 and 55 N m"));
  EXPECT_NEAR(report.torque.value, 1.0 + 23.0 / 55.0, 1e-6);
  EXPECT_NEAR(report.torque.time, 0.5, 1e-6);
}

TEST(TorquePeak, BeyondTheNoLoadSpeedNothingDrivesAndAllBrakes) {
  Problem problem = problem_with(TorqueSpeedLine{60.0, 2.0}, 0.0);
  problem.arms[0].gravity = {};
  const std::vector<Knot> cruise = {{0.0, 0.0, 2.5, 0.0, 0.0}, {0.5, 1.25, 2.5, 0.0, 0.0}};
  EXPECT_NEAR(limits_of(problem.arms[0], cruise).torque.value, 0.0, 1e-9);
  const double braking = -60.0 / 39.0;
  const std::vector<Knot> brake = {{0.0, 0.0, 2.5, braking, -60.0},
                                   {0.1, 0.25 + 0.005 * braking, 2.5 + 0.1 * braking, braking, -60.0}};
  EXPECT_NEAR(limits_of(problem.arms[0], brake).torque.value, 1.0, 1e-9);
  problem.arms[0].viscous_friction = 1.2;  // 3 N m at 2.5 rad/s, above 0 by a tenth of half the width of 60
  const LimitReport report = limits_of(problem.arms[0], cruise);
  ASSERT_EQ(report.violations.size(), 1u);
  EXPECT_NEAR(report.torque.value, 1.1, 1e-9);
}

TEST(TorquePeak, RestingOrCruisingOnABendIsJudgedLikeAnywhere) {
  const TorqueTable peaked = {{0.5, 1.0, 1.5},
                              {-1.0, 0.0, 1.0},
                              {{-30.0, 30.0},
                               {-50.0, 50.0},
                               {-30.0, 30.0},
                               {-50.0, 50.0},
                               {-90.0, 90.0},
                               {-50.0, 50.0},
                               {-30.0, 30.0},
                               {-50.0, 50.0},
                               {-30.0, 30.0}}};
  Problem problem = problem_with(peaked, 10.0);
  problem.arms[0].gravity = {45.0, 1.0 - 0.5 * std::numbers::pi};
  const std::vector<Knot> rest = {{0.0, 1.0, 0.0, 0.0, 45.0}, {3600.0, 1.0, 0.0, 0.0, 45.0}};
  EXPECT_NEAR(limits_of(problem.arms[0], rest).torque.value, 0.5, 1e-9);
  problem.arms[0].gravity = {};
  const std::vector<Knot> cruise = {{0.0, 0.7, 1.0, 0.0, 10.0}, {0.6, 1.3, 1.0, 0.0, 10.0}};
  EXPECT_NEAR(limits_of(problem.arms[0], cruise).torque.value, 10.0 / 38.0, 1e-9);
}

TEST(TorquePeak, LimitsThatSomewhereLeaveOutZeroAreJudgedFromTheirMiddle) {
  const TorqueTable lifting = {{0.0, 2.0}, {0.0}, {{-10.0, 50.0}, {10.0, 50.0}}};
  Problem problem = problem_with(lifting, 0.0);
  problem.arms[0].gravity = {20.0, 1.0 - 0.5 * std::numbers::pi};
  const std::vector<Knot> rest = {{0.0, 1.0, 0.0, 0.0, 20.0}, {1.0, 1.0, 0.0, 0.0, 20.0}};
  EXPECT_NEAR(limits_of(problem.arms[0], rest).torque.value, 0.2, 1e-9) << "0 and 50, so 5 of 25 from the middle";
}

TEST(TorquePeak, ALimitThatRisesAndFallsAboutTheMiddleOfAPieceIsSeenThroughItsThirdDerivative) {
  constexpr double kWay = 0.01;
  // Position (then velocity) goes about 1 as u (1 - u) (1 - 2 u): there at both ends and in the middle, where nothing
  // is curved. No torque is needed, so that only the limits move.
  const std::vector<Knot> about_a_position = {{0.0, 1.0, kWay, -6.0 * kWay, 0.0}, {1.0, 1.0, kWay, 6.0 * kWay, 0.0}};
  const std::vector<Knot> about_a_velocity = {{0.0, 1.0, 1.0, kWay, 0.0}, {1.0, 2.0, 1.0, kWay, 0.0}};
  const TorqueTable over_positions = {{0.0, 2.0}, {0.0}, {{-10.0, 100.0}, {10.0, 100.0}}};
  const TorqueTable over_velocities = {{0.0}, {0.0, 2.0}, {{-10.0, 100.0}, {10.0, 100.0}}};
  for (const auto& [table, knots] :
       {std::pair{over_positions, about_a_position}, std::pair{over_velocities, about_a_velocity}}) {
    Problem problem = problem_with(table, 0.0);
    Arm& arm = problem.arms[0];
    arm.gravity = {};
    arm.inertia = 1e-12;
    const LimitReport report = limits_of(arm, knots);
    const double lower = 10.0 * kWay * std::sqrt(3.0) / 18.0;
    EXPECT_NEAR(report.torque.value, (100.0 + lower) / (100.0 - lower), 1e-9);
    EXPECT_EQ(report.violations.size(), 1u);
  }
}

TEST(TorquePeak, NumbersBeyondAllBoundsEndTheSearchAtOnce) {
  Problem problem = problem_with(uneven_table(), 4.0);
  for (const double position : {1e10, 1e100, 1e300}) {
    const LimitReport report = limits_of(problem.arms[0], {{0.0, 0.5, 0.0, 0.0, 0.0}, {1e-9, position, 0.0, 0.0, 0.0}});
    ASSERT_FALSE(report.violations.empty());
    EXPECT_EQ(report.violations.back().kind, ViolationKind::kTorque);
  }
}

/// A table of a few bends in random places, wider than 0 on either side or (`is_lifting`) anywhere.
TorqueTable random_table(std::mt19937_64& random, bool is_lifting) {
  const auto between = [&](double least, double most) { return std::uniform_real_distribution(least, most)(random); };
  const auto grid = [&](int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(between(-1.5, 1.5));
    std::sort(values.begin(), values.end());
    return values;
  };
  TorqueTable table = {grid(1 + static_cast<int>(random() % 5)), grid(1 + static_cast<int>(random() % 5)), {}};
  for (std::size_t i = 0; i < table.positions.size() * table.velocities.size(); ++i) {
    const double upper = between(1.0, 60.0);
    table.limits.push_back({is_lifting ? upper - between(1.0, 60.0) : -between(1.0, 60.0), upper});
  }
  return table;
}

/// Largest value seen at even times, then at ever finer ones about the best.
double sampled_peak(const std::function<double(double)>& share, Interval time, int count, int refinements) {
  double best = time.lower;
  for (int i = 0; i <= count; ++i) {
    const double at = time.lower + time.length() * i / count;
    if (share(at) > share(best)) best = at;
  }
  if (refinements == 0) return share(best);
  const double step = time.length() / count;
  const Interval around = {std::max(time.lower, best - step), std::min(time.upper, best + step)};
  return std::max(share(best), sampled_peak(share, around, 200, refinements - 1));
}

TEST(TorquePeak, IsNeverBelowSamplesAndNeverFarAbove) {
  std::mt19937_64 random(20240607);
  const auto between = [&](double least, double most) { return std::uniform_real_distribution(least, most)(random); };
  for (int trial = 0; trial < 400; ++trial) {
    SCOPED_TRACE(testing::Message() << "trial " << trial);
    const bool is_lifting = trial % 5 == 4;
    TorqueLimit limit = random_table(random, is_lifting);
    if (trial % 5 == 3) limit = TorqueSpeedLine{between(1.0, 60.0), between(0.2, 2.0)};
    Problem problem = problem_with(limit, trial % 2 == 0 ? 0.0 : between(0.0, 20.0));
    Arm& arm = problem.arms[0];
    arm.inertia = 2.0;
    arm.gravity.amplitude = between(0.0, 20.0);
    const double duration = between(0.5, 3.0);
    const auto knot = [&](double time) {
      return Knot{time, between(-1.2, 1.2), between(-1.5, 1.5), between(-1.5, 1.5), 0.0};
    };
    const std::vector<Knot> knots = {knot(0.0), knot(duration)};
    const Quintic piece(knots[0], knots[1]);
    bool has_zero = true;
    if (const auto* table = std::get_if<TorqueTable>(&limit)) {
      for (const Interval& limits : table->limits) has_zero = has_zero && limits.contains(0.0);
    }
    const auto share = [&](double time) {
      const JointState state = {piece.derivative(0, time), piece.derivative(1, time)};
      const Interval limits = torque_limits(limit, state.position, state.velocity);
      const double torque = JointTorque(arm).at(state, piece.derivative(2, time));
      return (has_zero ? Share::by_side(limits) : Share::from_middle(limits)).of(torque);
    };
    const double sampled = sampled_peak(share, {0.0, duration}, 20000, 6);
    const LimitReport report = limits_of(arm, knots);
    EXPECT_GE(report.torque.value, sampled - 1e-12);
    EXPECT_LE(report.torque.value, sampled + 1e-8 * std::max(1.0, sampled));
  }
}

}  // namespace
}  // namespace dualarm
