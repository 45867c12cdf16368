#include "core/phase_plane/portrait.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "tests/core/phase_plane/rig.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPi = std::numbers::pi;

/// Speeds this far (rad/s) from the limit curve are told apart by the simulation.
constexpr double kApart = 1e-4;

/// Rest where braking vanishes: there a rounding decides whether the arm is held.
bool is_unstable_rest(const System& system, JointState state) {
  const Interval held = system.acceleration(state.position, 0.0);
  return std::abs(state.velocity) < kApart && std::min(std::abs(held.lower), std::abs(held.upper)) < 1e-9;
}

void expect_limits_are_tight(const System& system, int resolution) {
  const PhasePortrait portrait = draw_portrait(system, {system.range().lower, 0.0}, resolution);
  for (const double way : {1.0, -1.0}) {
    const std::vector<JointState>& curve = way > 0.0 ? portrait.upper_limit : portrait.lower_limit;
    for (const JointState& state : curve) {
      SCOPED_TRACE(testing::Message() << "way " << way << ", position " << state.position << ", velocity "
                                      << state.velocity);
      EXPECT_GE(way * state.velocity, 0.0);
      const double below = std::max(0.0, way * state.velocity - kApart);
      const double above = way * state.velocity + kApart;
      if (!is_unstable_rest(system, state)) {
        EXPECT_TRUE(braked_to_rest(system, {state.position, std::copysign(below, way)}));
      }
      EXPECT_FALSE(braked_to_rest(system, {state.position, way * above}));
    }
    // Where the curve has no state, not even rest is safe.
    for (int k = 0; k <= 40; ++k) {
      const double s = std::lerp(system.range().lower, system.range().upper, k / 40.0);
      const auto near = [&](const JointState& state) {
        return std::abs(state.position - s) <= 2.0 * system.range().length() / (resolution - 1);
      };
      if (std::any_of(curve.begin(), curve.end(), near)) continue;
      EXPECT_FALSE(braked_to_rest(system, {s, std::copysign(0.0, way)})) << "way " << way << ", rest at " << s;
    }
  }
}

/// Largest speed in each of `cells` + 1 columns from which one column's work of braking leads below the next column's.
std::vector<double> limit_on_grid(const System& system, int cells) {
  const double ds = system.range().length() / cells;
  const double top = std::min(system.velocity().upper, 20.0);
  std::vector<double> highest(cells + 1, -1.0);  // below 0: none
  if (system.acceleration(system.range().upper, 0.0).lower <= 0.0) highest.back() = 0.0;
  for (int i = cells - 1; i >= 0; --i) {
    const double s = system.range().lower + (i + 0.5) * ds;
    const auto safe = [&](double v) {
      const double square = v * v + 2.0 * ds * system.acceleration(s, v).lower;
      return square <= 0.0 || (std::sqrt(square) <= highest[i + 1]);
    };
    if (!safe(0.0)) continue;
    highest[i] = safe(top) ? top : 0.0;
    for (double step = 0.5 * top; step > 1e-9; step *= 0.5) {
      if (safe(highest[i] + step)) highest[i] += step;
    }
    highest[i] = std::min(highest[i], top);
  }
  return highest;
}

TEST(Portrait, OfADoubleIntegratorIsParabolasToTheLastDigits) {
  const Rig system({-1.0, 3.0}, {-kInfinity, kInfinity}, false, [](double, double) -> Interval { return {-2.0, 0.5}; });
  const PhasePortrait portrait = draw_portrait(system, {1.0, 0.0}, 101);
  ASSERT_EQ(portrait.upper_limit.size(), 101u);
  ASSERT_EQ(portrait.lower_limit.size(), 101u);
  ASSERT_EQ(portrait.rising_switch.size(), 101u);
  ASSERT_EQ(portrait.falling_switch.size(), 101u);
  constexpr double kClosedForm = 1e-12;  // rad/s
  for (int k = 0; k <= 100; ++k) {
    EXPECT_NEAR(portrait.upper_limit[k].position, -1.0 + 0.04 * k, kClosedForm);
    EXPECT_NEAR(portrait.upper_limit[k].velocity, std::sqrt(4.0 * (3.0 - portrait.upper_limit[k].position)),
                kClosedForm);
    EXPECT_NEAR(portrait.lower_limit[k].velocity, -std::sqrt(1.0 * (portrait.lower_limit[k].position + 1.0)),
                kClosedForm);
    EXPECT_NEAR(portrait.rising_switch[k].position, -1.0 + 0.02 * k, kClosedForm);
    EXPECT_NEAR(portrait.rising_switch[k].velocity, std::sqrt(4.0 * (1.0 - portrait.rising_switch[k].position)),
                kClosedForm);
    EXPECT_NEAR(portrait.falling_switch[k].position, 1.0 + 0.02 * k, kClosedForm);
    EXPECT_NEAR(portrait.falling_switch[k].velocity, -std::sqrt(1.0 * (portrait.falling_switch[k].position - 1.0)),
                kClosedForm);
  }
}

TEST(Portrait, WithFrictionAloneIsAStraightLine) {
  // No torque to brake with but friction: dv/ds = -b.
  const Rig system({0.0, 2.0}, {-kInfinity, kInfinity}, true, [](double, double v) -> Interval {
    return {-3.0 * v - 1e-30, 1.0 - 3.0 * v};
  });
  const PhasePortrait portrait = draw_portrait(system, {2.0, 0.5}, 21);
  ASSERT_EQ(portrait.rising_switch.size(), 21u);
  for (const JointState& state : portrait.rising_switch) {
    EXPECT_NEAR(state.velocity, 0.5 + 3.0 * (2.0 - state.position), 1e-10);
  }
}

TEST(Portrait, WithFrictionAndAConstantBrakeIsItsLogarithm) {
  constexpr double kBrake = 1.0;  // rad/s2
  constexpr double kRate = 6.0;   // 1/s
  const Rig system({0.0, 3.0}, {-kInfinity, kInfinity}, true, [](double, double v) -> Interval {
    return {-kBrake - kRate * v, kBrake - kRate * v};
  });
  const PhasePortrait portrait = draw_portrait(system, {3.0, 0.0}, 40);
  ASSERT_EQ(portrait.rising_switch.size(), 40u);
  for (const JointState& state : portrait.rising_switch) {
    const double way = state.velocity / kRate - kBrake / kRate / kRate * std::log1p(kRate * state.velocity / kBrake);
    EXPECT_NEAR(3.0 - state.position, way, 1e-11) << state.velocity;
  }
}

TEST(Portrait, KeepsToTheVelocityLimitWhereBrakingHoldsIt) {
  const Rig system = pendulum(60.0 / 39.0, 29.43 / 39.0, 0.0, 0.0, {0.0, kPi}, {-2.0, 1.0});
  const PhasePortrait portrait = draw_portrait(system, {1.0, 0.0}, 181);
  EXPECT_EQ(portrait.upper_limit[20].velocity, 1.0);
  EXPECT_EQ(portrait.upper_limit.front().position, 0.0);
  EXPECT_EQ(portrait.upper_limit.back().position, kPi);
  EXPECT_EQ(portrait.upper_limit.back().velocity, 0.0);
  EXPECT_EQ(portrait.rising_switch.front().velocity, 1.0);
  EXPECT_GT(portrait.rising_switch.front().position, 0.0);
  expect_limits_are_tight(system, 37);
}

TEST(Portrait, OfStrongDrivesIsTight) {
  expect_limits_are_tight(pendulum(2.0, 1.0, 0.0, 0.0, {0.0, kPi}, {-kInfinity, kInfinity}), 25);
  expect_limits_are_tight(pendulum(2.0, 1.0, 0.3, 0.4, {-1.0, 2.0}, {-1.5, 0.8}), 25);
}

TEST(Portrait, LeavesOutWhereNotEvenRestIsSafe) {
  // Gravity is stronger than the brake between asin(0.8) and pi - asin(0.8) before and after each upright position.
  const Rig system = pendulum(0.8, 1.0, 0.0, 0.0, {-2.0 * kPi, 2.0 * kPi}, {-kInfinity, kInfinity});
  expect_limits_are_tight(system, 101);
  const Rig down = pendulum(0.8, 1.0, 0.0, 0.0, {0.2, 5.0}, {-kInfinity, kInfinity});
  expect_limits_are_tight(down, 101);
  const std::vector<JointState> upper = draw_portrait(down, {1.0, 0.0}, 101).upper_limit;
  // At 5.0 gravity pulls up with sin(5) = -0.96: the last place from which braking holds is pi + asin(0.8).
  EXPECT_NEAR(upper.back().position, kPi + std::asin(0.8), 1e-12);
  EXPECT_NEAR(upper.back().velocity, 0.0, 1e-6);
}

TEST(Portrait, LeavesOutAGapBetweenTwoSafeStretches) {
  // Braking fails over (1, 2), and what it lets through there cannot be stopped before the range ends at 2.2.
  const Rig system({0.0, 2.2}, {-5.0, 5.0}, false, [](double s, double) -> Interval {
    return {3.0 * (s - 1.0) * (2.0 - s) + 0.0, 4.0};
  });
  const std::vector<JointState> upper = draw_portrait(system, {0.5, 0.0}, 111).upper_limit;
  EXPECT_LT(upper.size(), 111u);
  for (std::size_t k = 1; k < upper.size(); ++k) {
    const double apart = upper[k].position - upper[k - 1].position;
    EXPECT_NEAR(std::remainder(apart, 2.2 / 110.0), 0.0, 1e-12);
  }
  expect_limits_are_tight(system, 111);
}

TEST(Portrait, FollowsTheArcBelowATrapOfTheVelocityLimit) {
  for (const double friction : {0.0, 0.05}) {
    SCOPED_TRACE(friction);
    // Past upright gravity pulls harder than the brake, and then lets go in time.
    const Rig system({0.0, 6.0}, {-1.2, 1.2}, friction > 0.0, [=](double s, double v) -> Interval {
      return {-0.5 + 1.1 * std::exp(-8.0 * (s - 3.0) * (s - 3.0)) - friction * v, 2.0 - friction * v};
    });
    const std::vector<JointState> upper = draw_portrait(system, {1.0, 0.0}, 121).upper_limit;
    EXPECT_EQ(upper[20].velocity, 1.2);
    EXPECT_LT(upper[55].velocity, 1.1);
    EXPECT_EQ(upper[75].velocity, 1.2);
    expect_limits_are_tight(system, 121);
  }
}

TEST(Portrait, IsFiniteWithoutLimitsAndWithTheStrongestFriction) {
  const Rig system = pendulum(1.0, 0.5, 0.0, 1e21, {-1000.0, 1000.0}, {-kInfinity, kInfinity});
  const PhasePortrait portrait = draw_portrait(system, {0.0, 0.0}, 50);
  for (const auto* curve :
       {&portrait.upper_limit, &portrait.lower_limit, &portrait.rising_switch, &portrait.falling_switch}) {
    ASSERT_EQ(curve->size(), 50u);
    for (const JointState& state : *curve) EXPECT_TRUE(std::isfinite(state.velocity)) << state.position;
  }
  EXPECT_NEAR(portrait.upper_limit.front().velocity / 2e24, 1.0, 1e-6);
}

TEST(Portrait, AgreesWithAGridOfReachableStates) {
  const std::vector<Rig> rigs = {
      pendulum(2.0, 1.0, 0.0, 0.0, {0.0, kPi}, {-2.0, 2.0}),
      pendulum(0.8, 1.0, 0.0, 0.0, {0.2, 5.0}, {-3.0, 3.0}),
      pendulum(0.9, 1.0, 1.0, 0.3, {-2.0, 4.0}, {-1.0, 1.0}),
      Rig({0.0, 6.0}, {-1.2, 1.2}, true,
          [](double s, double v) -> Interval {
            return {-0.5 + 0.1 * v + 1.1 * std::exp(-8.0 * (s - 3.0) * (s - 3.0)), 2.0};
          }),
  };
  for (std::size_t r = 0; r < rigs.size(); ++r) {
    SCOPED_TRACE(testing::Message() << "rig " << r);
    constexpr int kCells = 1200;
    const std::vector<double> grid = limit_on_grid(rigs[r], kCells);
    const auto upper = draw_portrait(rigs[r], {rigs[r].range().lower, 0.0}, kCells + 1).upper_limit;
    ASSERT_GT(upper.size(), 200u);
    for (const JointState& state : upper) {
      const double at = (state.position - rigs[r].range().lower) / rigs[r].range().length() * kCells;
      const int cell = std::clamp(static_cast<int>(std::lround(at)), 2, kCells - 2);
      const auto [low, high] = std::minmax_element(grid.begin() + cell - 2, grid.begin() + cell + 3);
      constexpr double kGridError = 0.06;  // rad/s: the square root of a cell's work near rest
      EXPECT_GE(state.velocity, *low - kGridError) << state.position;
      EXPECT_LE(state.velocity, *high + kGridError) << state.position;
    }
  }
}

TEST(Portrait, FromTheSwitchingCurveFullBrakingReachesTheGoal) {
  constexpr double kEnd = 1e-7;  // rad: what is promised of arcs that are integrated
  const std::vector<Rig> rigs = {
      pendulum(60.0 / 39.0, 29.43 / 39.0, 0.0, 0.0, {0.0, kPi}, {-2.0, 2.0}),
      pendulum(0.9, 1.0, 0.2, 0.0, {-4.0, 4.0}, {-kInfinity, kInfinity}),
      pendulum(1.2, 1.0, 0.2, 0.35, {-4.0, 4.0}, {-1.1, 1.7}),
      Rig({-3.0, 3.0}, {-2.0, 2.0}, true,
          [](double s, double v) -> Interval {
            return {-1.0 - 0.2 * std::sin(3.0 * s) + 0.2 * v, 1.1 + 0.3 * v};
          }),
  };
  for (std::size_t r = 0; r < rigs.size(); ++r) {
    const JointState goal = {0.7, 0.0};
    const PhasePortrait portrait = draw_portrait(rigs[r], goal, 24);
    ASSERT_EQ(portrait.rising_switch.size(), 24u);
    ASSERT_EQ(portrait.falling_switch.size(), 24u);
    EXPECT_EQ(portrait.rising_switch.back().position, goal.position);
    EXPECT_EQ(portrait.falling_switch.front().position, goal.position);
    for (const auto* curve : {&portrait.rising_switch, &portrait.falling_switch}) {
      for (const JointState& state : *curve) {
        SCOPED_TRACE(testing::Message() << "rig " << r << ", " << state.position << ", " << state.velocity);
        const std::optional<double> rest = braked_to_rest(rigs[r], state);
        ASSERT_TRUE(rest);
        EXPECT_NEAR(*rest, goal.position, kEnd);
      }
    }
  }
}

TEST(Portrait, TheSwitchingCurveOfAMovingGoalHasOneBranch) {
  const Rig system = pendulum(2.0, 1.0, 0.0, 0.0, {-1.0, 3.0}, {-4.0, 4.0});
  const PhasePortrait rising = draw_portrait(system, {1.0, 0.5}, 30);
  ASSERT_EQ(rising.rising_switch.size(), 30u);
  EXPECT_DOUBLE_EQ(rising.rising_switch.back().velocity, 0.5);
  EXPECT_TRUE(rising.falling_switch.empty());
  for (const JointState& state : rising.rising_switch) {
    const double work = -2.0 * (1.0 - state.position) + std::cos(1.0) - std::cos(state.position);
    EXPECT_NEAR(0.5 * state.velocity * state.velocity + work, 0.125, 1e-12);
  }
  const PhasePortrait falling = draw_portrait(system, {1.0, -0.5}, 30);
  EXPECT_TRUE(falling.rising_switch.empty());
  EXPECT_DOUBLE_EQ(falling.falling_switch.front().velocity, -0.5);
}

TEST(Portrait, HasNoSwitchingCurveWhereNoArcEnds) {
  const Rig weak = pendulum(0.5, 1.0, 0.0, 0.0, {-1.0, 4.0}, {-4.0, 4.0});
  // At -pi/2 + 1 the brake does not hold a rising arm, and at pi/2 a falling one.
  EXPECT_TRUE(draw_portrait(weak, {-0.6, 0.0}, 10).rising_switch.empty());
  EXPECT_FALSE(draw_portrait(weak, {-0.6, 0.0}, 10).falling_switch.empty());
  EXPECT_TRUE(draw_portrait(weak, {kPi / 2, 0.0}, 10).falling_switch.empty());
  EXPECT_FALSE(draw_portrait(weak, {kPi / 2, 0.0}, 10).rising_switch.empty());
  const Rig rubbing = pendulum(0.5, 1.0, 0.0, 0.2, {-1.0, 4.0}, {-4.0, 4.0});
  EXPECT_TRUE(draw_portrait(rubbing, {-0.6, 0.0}, 10).rising_switch.empty());
  EXPECT_TRUE(draw_portrait(rubbing, {kPi / 2, 0.0}, 10).falling_switch.empty());
  for (const JointState& goal : {JointState{9.0, 0.0}, JointState{1.0, 9.0}, JointState{1.0, -9.0}}) {
    EXPECT_TRUE(draw_portrait(weak, goal, 10).rising_switch.empty());
    EXPECT_TRUE(draw_portrait(weak, goal, 10).falling_switch.empty());
    EXPECT_FALSE(draw_portrait(weak, goal, 10).upper_limit.empty());
  }
  const PhasePortrait at_end = draw_portrait(pendulum(2.0, 1.0, 0.0, 0.0, {-1.0, 3.0}, {-4.0, 4.0}), {-1.0, 0.0}, 10);
  EXPECT_TRUE(at_end.rising_switch.empty());
  EXPECT_FALSE(at_end.falling_switch.empty());
}

TEST(Portrait, IsEmptyWhereBrakingNeverHolds) {
  const Rig system({0.0, 1.0}, {-1.0, 1.0}, false, [](double, double) -> Interval { return {0.5, 1.5}; });
  const PhasePortrait portrait = draw_portrait(system, {0.5, 0.0}, 10);
  EXPECT_TRUE(portrait.upper_limit.empty());
  EXPECT_FALSE(portrait.lower_limit.empty());
}

TEST(Portrait, OfAMirroredSystemIsMirrored) {
  // With a trap in either direction, whose ends depend on the sign of the velocity.
  const auto law = [](double s, double v) -> Interval {
    const double pull = 1.1 * std::exp(-8.0 * (s - 2.0) * (s - 2.0)) - 1.4 * std::exp(-8.0 * (s - 0.5) * (s - 0.5));
    return {-0.7 + pull - 0.2 * v, 0.9 + pull - 0.2 * v};
  };
  const Rig system({-1.0, 4.0}, {-1.5, 0.9}, true, law);
  const Rig mirror({-4.0, 1.0}, {-0.9, 1.5}, true, [law](double s, double v) -> Interval {
    const Interval a = law(-s, -v);
    return {-a.upper, -a.lower};
  });
  const PhasePortrait one = draw_portrait(system, {1.0, 0.0}, 61);
  const PhasePortrait other = draw_portrait(mirror, {-1.0, 0.0}, 61);
  const auto expect_mirrored = [](const std::vector<JointState>& curve, const std::vector<JointState>& mirrored) {
    ASSERT_EQ(curve.size(), mirrored.size());
    ASSERT_FALSE(curve.empty());
    for (std::size_t k = 0; k < curve.size(); ++k) {
      EXPECT_NEAR(curve[k].position, -mirrored[curve.size() - 1 - k].position, 1e-12);
      EXPECT_NEAR(curve[k].velocity, -mirrored[curve.size() - 1 - k].velocity, 1e-9);
    }
  };
  expect_limits_are_tight(system, 61);
  expect_limits_are_tight(mirror, 61);
  expect_mirrored(one.upper_limit, other.lower_limit);
  expect_mirrored(one.lower_limit, other.upper_limit);
  expect_mirrored(one.rising_switch, other.falling_switch);
  expect_mirrored(one.falling_switch, other.rising_switch);
}

TEST(Portrait, OfSeededSystemsIsTight) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    const double low = uniform(-4.0, 0.0);
    const Interval range = {low, low + uniform(0.5, 7.0)};
    const Interval velocity =
        seed % 3 == 0 ? Interval{-kInfinity, kInfinity} : Interval{-uniform(0.3, 2.0), uniform(0.3, 2.0)};
    const double friction = seed % 2 == 0 ? uniform(0.02, 0.6) : 0.0;
    expect_limits_are_tight(pendulum(uniform(0.4, 1.6), 1.0, uniform(-3.0, 3.0), friction, range, velocity), 19);
  }
}

}  // namespace
}  // namespace dualarm
