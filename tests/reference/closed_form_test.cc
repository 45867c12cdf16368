#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Of a duration.
constexpr double kExact = 1e-12;
/// Of a position: arcs pass on positions in double, and where the end is slow a rounding of them is time.
constexpr double kRoundings = 8.0 * std::numeric_limits<double>::epsilon();

/// x'' in [-braking, driving], x' in [slowest, fastest].
struct Vehicle {
  double driving = 1.0;  // m/s2, > 0, or rad/s2
  double braking = 1.0;  // > 0
  double slowest = -kInfinity;
  double fastest = kInfinity;
};

/// The least time of the double integrator between any two states, in closed form. The straight change of velocity
/// takes it by `direct`; a goal beyond that needs a higher velocity in between, a goal before it a lower one.
double least_time(const Vehicle& vehicle, JointState start, JointState goal) {
  const double a = vehicle.driving;
  const double d = vehicle.braking;
  const double v = start.velocity;
  const double w = goal.velocity;
  const double distance = goal.position - start.position;
  const double direct = w >= v ? 0.5 * (w * w - v * v) / a : 0.5 * (v * v - w * w) / d;
  if (distance >= direct) {
    const double peak = std::sqrt((2.0 * distance + v * v / a + w * w / d) / (1.0 / a + 1.0 / d));
    const double top = std::min(peak, vehicle.fastest);
    const double ramps = 0.5 * (top * top - v * v) / a + 0.5 * (top * top - w * w) / d;
    return (top - v) / a + (top - w) / d + (peak > top ? (distance - ramps) / top : 0.0);
  }
  const double peak = -std::sqrt((v * v / d + w * w / a - 2.0 * distance) / (1.0 / a + 1.0 / d));
  const double top = std::max(peak, vehicle.slowest);
  const double ramps = 0.5 * (v * v - top * top) / d + 0.5 * (w * w - top * top) / a;
  return (v - top) / d + (w - top) / a + (peak < top ? (distance - ramps) / top : 0.0);
}

double solved_time(const Vehicle& vehicle, JointState start, JointState goal) {
  constexpr double kInertia = 2.0;
  Arm arm;
  arm.name = "vehicle";
  arm.length = 1.0;
  arm.inertia = kInertia;
  arm.torque = Interval{-kInertia * vehicle.braking, kInertia * vehicle.driving};
  arm.joint_range = {-100.0, 100.0};
  arm.velocity = {vehicle.slowest, vehicle.fastest};
  const SingleJointArm system(arm);
  const auto answer = fastest_motion(system, start, goal);
  const auto* motion = std::get_if<FastestMotion>(&answer);
  if (motion == nullptr) return kInfinity;
  EXPECT_EQ(motion->minimum_over, MinimumOver::kAllMotions);
  EXPECT_EQ(motion->lower_bound, motion->profile.duration());
  return motion->profile.duration();
}

void expect_closed_form(const Vehicle& vehicle, JointState start, JointState goal) {
  const double expected = least_time(vehicle, start, goal);
  double slowest = 1.0;
  for (const double speed : {std::abs(start.velocity), std::abs(goal.velocity)}) {
    if (speed > 0.0) slowest = std::min(slowest, speed);
  }
  const double rounding = kRoundings * std::max(std::abs(start.position), std::abs(goal.position)) / slowest;
  EXPECT_NEAR(solved_time(vehicle, start, goal), expected, kExact * expected + rounding)
      << start.position << ", " << start.velocity << " -> " << goal.position << ", " << goal.velocity << " under -"
      << vehicle.braking << " to " << vehicle.driving << ", " << vehicle.slowest << " to " << vehicle.fastest;
}

TEST(ClosedForm, OfTheDoubleIntegratorHoldsForEverySignOfEveryBoundaryVelocity) {
  for (const double v : {-3.0, -1.0, 0.0, 0.5, 2.0}) {
    for (const double w : {-2.5, -0.5, 0.0, 1.0, 3.0}) {
      for (const double distance : {-7.0, -1.0, -0.01, 0.01, 0.3, 2.0, 9.0}) {
        expect_closed_form({2.0, 3.0, -kInfinity, kInfinity}, {0.25, v}, {0.25 + distance, w});
      }
    }
  }
}

TEST(ClosedForm, OfTheTrapezoidHoldsForEverySignOfEveryBoundaryVelocity) {
  for (const double v : {-2.0, -1.0, 0.0, 0.5, 1.5}) {
    for (const double w : {-2.0, -0.5, 0.0, 1.0, 1.5}) {
      for (const double distance : {-17.0, -3.0, -0.3, 0.3, 2.0, 19.0}) {
        expect_closed_form({2.0, 3.0, -2.0, 1.5}, {0.25, v}, {0.25 + distance, w});
      }
    }
  }
}

TEST(ClosedForm, HoldsForRandomVehicles) {
  constexpr std::uint64_t kSeed = 5;
  std::mt19937_64 engine(kSeed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11U) * 0x1.0p-53);
  };
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", draw " << i);
    const Vehicle vehicle = {between(0.1, 5.0), between(0.1, 5.0), -between(0.5, 3.0), between(0.5, 3.0)};
    const JointState start = {between(-3.0, 3.0), between(vehicle.slowest, vehicle.fastest)};
    const JointState goal = {between(-3.0, 3.0), between(vehicle.slowest, vehicle.fastest)};
    expect_closed_form(vehicle, start, goal);
  }
}

TEST(ClosedForm, HoldsForPureChangesOfVelocity) {
  // One arc: the goal lies on the arc through the start, where one of the two arcs of the general answer has no length.
  for (const double w : {0.0, 0.5, 1.5, 2.0}) {
    expect_closed_form({2.0, 4.0, -kInfinity, kInfinity}, {0.0, 1.0},
                       {w >= 1.0 ? (w * w - 1.0) / 4.0 : (1.0 - w * w) / 8.0, w});
  }
}

TEST(ClosedForm, HoldsForTheMotionFromAStateToItself) {
  EXPECT_EQ(solved_time({1.0, 1.0, -kInfinity, kInfinity}, {0.5, 0.7}, {0.5, 0.7}), 0.0);
  EXPECT_EQ(solved_time({1.0, 1.0, -kInfinity, kInfinity}, {0.5, 0.0}, {0.5, 0.0}), 0.0);
}

TEST(ClosedForm, HoldsForTheTurnOnTheSpot) {
  // From v to -v at the same place: braking through zero, nothing else.
  expect_closed_form({2.0, 3.0, -kInfinity, kInfinity}, {0.0, 1.5}, {0.0, -1.5});
  expect_closed_form({2.0, 3.0, -kInfinity, kInfinity}, {0.0, -1.5}, {0.0, 1.5});
}

}  // namespace
}  // namespace dualarm
