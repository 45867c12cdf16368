#include "tests/reference/minimum_time_grid.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "tests/reference/random_drive.h"
#include "tests/reference/random_motions.h"

// The reference is itself held to closed forms, to theory's table, and to motions that were driven at random.

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPi = std::numbers::pi;

Arm arm_with(double gravity, double torque, double speed) {
  Arm arm;
  arm.inertia = 1.0;
  arm.gravity = {gravity, 0.0};
  arm.torque = Interval{-torque, torque};
  arm.joint_range = {-10.0, 10.0};
  arm.velocity = {-speed, speed};
  return arm;
}

TEST(MinimumTimeGrid, MeetsTheClosedFormOfTheDoubleIntegratorWithinItsOwnError) {
  // With boundary velocities: x = 1 from 0, v = -1 to 0.5, |a| <= 2. Switch energy e: full drive from the turn.
  const auto rest = minimum_time_by_grid(arm_with(0.0, 4.0, kInfinity), {0.0, 0.0}, {1.0, 0.0});
  ASSERT_TRUE(rest);
  EXPECT_NEAR(rest->duration, 1.0, 1e-6);
  EXPECT_LT(rest->error, 1e-5);
  const auto turning = minimum_time_by_grid(arm_with(0.0, 2.0, kInfinity), {0.0, -1.0}, {1.0, 0.5});
  ASSERT_TRUE(turning);
  // Back to -1/4 in 1/2 s, then 5/4 rad: peak^2 = (2 * 2 * 5/4 + 1/4) / 2, times peak/2 + (peak - 1/2)/2.
  const double peak = std::sqrt(2.625);
  EXPECT_NEAR(turning->duration, 0.5 + 0.5 * peak + 0.5 * (peak - 0.5), 1e-6);
}

TEST(MinimumTimeGrid, MeetsTheTrapezoid) {
  const auto found = minimum_time_by_grid(arm_with(0.0, 4.0, 2.0), {0.0, 0.0}, {3.0, 0.0});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->duration, 2.0, found->error + 1e-6);
}

TEST(MinimumTimeGrid, MeetsTheSwingTableOfTheory) {
  // theory.md, section 1.3: start, T/G, the better of monotone and back-swing, and its turning points.
  const struct {
    double start, torque, seconds;
    std::size_t turns;
  } rows[] = {{0.0, 0.60, 6.696, 1},       {0.0, 0.76, 5.790, 1},       {0.0, 0.80, 5.359, 0},
              {0.5 * kPi, 1.01, 5.872, 1}, {0.5 * kPi, 1.05, 5.785, 1}, {0.5 * kPi, 1.10, 5.062, 0}};
  for (const auto& row : rows) {
    const auto found = minimum_time_by_grid(arm_with(1.0, row.torque, kInfinity), {row.start, 0.0}, {kPi, 0.0});
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->duration, row.seconds, 5.1e-4);
    EXPECT_EQ(found->turning_points.size(), row.turns);
    EXPECT_LT(found->error, 1e-5);
  }
}

TEST(MinimumTimeGrid, FindsNothingWhereTheRangeForbidsTheSwing) {
  Arm arm = arm_with(1.0, 0.6, kInfinity);
  arm.joint_range = {0.0, kPi};
  EXPECT_FALSE(minimum_time_by_grid(arm, {0.0, 0.0}, {kPi, 0.0}));
}

class MinimumTimeGridOf : public testing::TestWithParam<Family> {};

TEST_P(MinimumTimeGridOf, IsNeverSlowerThanAnyMotionDrivenAtRandom) {
  constexpr int kDrives = 60;
  int missed = 0;
  for (int seed = 0; seed < kDrives; ++seed) {
    const MotionProblem problem = random_motion(GetParam(), 1000 + seed);
    SCOPED_TRACE(testing::Message() << "seed " << 1000 + seed << ": " << problem);
    const Drive drive = drive_at_random(problem.arm, problem.start, seed);
    const auto found = minimum_time_by_grid(problem.arm, problem.start, drive.end);
    if (!found) {
      ++missed;
      continue;
    }
    EXPECT_LE(found->duration, drive.duration + found->error + 1e-6);
  }
  // The ends of a single arc of all but full torque are so near the edge of what is reachable that the mesh misses
  // some.
  EXPECT_LE(missed, kDrives / 4);
}

INSTANTIATE_TEST_SUITE_P(EveryFamily, MinimumTimeGridOf, testing::ValuesIn(kEveryFamily),
                         [](const auto& family) { return name_of(family.param); });

}  // namespace
}  // namespace dualarm
