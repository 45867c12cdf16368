#include "core/verification/needed_torque.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/core/verification/loaded_arm.h"
#include "tests/support/dice.h"

namespace dualarm {
namespace {

/// Knots without any sense, a few of them at one time.
std::vector<Knot> wild_knots(Dice& dice, double longest) {
  std::vector<Knot> knots;
  double time = dice.between(0.0, 2.0);
  const auto count = static_cast<int>(dice.between(2.0, 12.0));
  for (int k = 0; k < count; ++k) {
    knots.push_back({time, dice.between(-2.0, 2.0), dice.between(-3.0, 3.0), dice.between(-9.0, 9.0), 0.0});
    if (dice.happens(0.8)) time += longest * dice.between(0.1, 1.0);
  }
  knots.push_back({time + longest, 0.3, 0.1, 0.2, 0.0});
  return knots;
}

/// The torque at a share of a piece: by the library's sine, from the piece's derivatives.
double torque_at(const JointTorque& torque, const Quintic& piece, double share) {
  const double time = std::lerp(piece.time().lower, piece.time().upper, share);
  return torque.at({piece.derivative(0, time), piece.derivative(1, time)}, piece.derivative(2, time));
}

/// Each of inertia, gravity and friction alone, so that none hides behind another, and all together.
const std::vector<Arm> kArms = {arm_with(2.0, 0.0, 0.0), arm_with(1e-9, 5.0, 0.0), arm_with(1e-9, -5.0, 0.0),
                                arm_with(1e-9, 0.0, 3.0), arm_with(2.0, 5.0, 3.0)};

TEST(NeededTorque, ContainsTheTorqueOfEveryPiece) {
  Dice dice(21);
  for (const Arm& arm : kArms) {
    const JointTorque torque(arm);
    for (int trial = 0; trial < 200; ++trial) {
      SCOPED_TRACE(testing::Message() << arm.inertia << " " << arm.viscous_friction << ", trial " << trial);
      const Interpolant motion(wild_knots(dice, std::pow(10.0, dice.between(-2.5, 0.5))));
      const NeededTorque needed(torque, motion);
      for (std::size_t i = 0; i < motion.piece_count(); ++i) {
        const Interval range = needed.range(i);
        const double rounding = 1e-12 * (1.0 + std::abs(range.lower) + std::abs(range.upper));
        const Quintic piece = motion.piece(i);
        const double start = torque_at(torque, piece, 0.0);
        const double end = torque_at(torque, piece, 1.0);
        for (int k = 0; k <= 40; ++k) {
          const double value = torque_at(torque, piece, k / 40.0);
          ASSERT_LE(value, range.upper + rounding);
          ASSERT_GE(value, range.lower - rounding);
          ASSERT_LE(std::abs(value - std::lerp(start, end, k / 40.0)), needed.departures_from_chord()[i] + rounding);
        }
        ASSERT_LE(needed.range().lower, range.lower);
        ASSERT_GE(needed.range().upper, range.upper);
      }
    }
  }
}

/// The remainder alone: gravity over pieces so long that the quintic through the ends of the torque tells little.
TEST(NeededTorque, CountsWhatInterpolationLeavesOfTheSine) {
  const JointTorque torque(arm_with(1e-9, 5.0, 0.0));
  for (const double turns : {0.3, 1.0, 3.0, 10.0}) {
    const Interpolant motion({{0.0, 0.4, 0.0, 0.0, 0.0}, {1.0, 0.4 + turns * 6.283185307179586, 0.0, 0.0, 0.0}});
    const Interval range = NeededTorque(torque, motion).range();
    EXPECT_LE(range.lower, -5.0 + (turns < 1.0 ? 5.0 : 0.0));
    EXPECT_GE(range.upper, 4.75);
  }
}

TEST(NeededTorque, AtKnotsIsThatOfTheirStates) {
  Dice dice(22);
  for (const Arm& arm : kArms) {
    const JointTorque torque(arm);
    const std::vector<Knot> knots = wild_knots(dice, 0.1);
    const NeededTorque needed(torque, Interpolant(knots));
    ASSERT_EQ(needed.at_knots().size(), knots.size());
    for (std::size_t k = 0; k < knots.size(); ++k) {
      EXPECT_NEAR(needed.at_knots()[k], torque.at({knots[k].position, knots[k].velocity}, knots[k].acceleration),
                  1e-14);
    }
  }
}

/// Of a swing that starts and ends as a motion of constant torque does the bound is as tight as the knots.
TEST(NeededTorque, FallsWithTheFourthPowerOfThePeriodWhereTorqueIsConstant) {
  const Arm arm = arm_with(2.0, 5.0, 0.0);
  const JointTorque torque(arm);
  const auto width = [&](double h) {
    // A Taylor series of the motion under 7 N m about its middle gives the states at both ends.
    const auto acceleration = [&](double q) { return (7.0 - 5.0 * std::sin(q - 0.4)) / 2.0; };
    const auto knot = [&](double time) {
      Knot at = {0.0, 0.3, 0.9, 0.0, 7.0};
      constexpr int kSteps = 2000;
      const double step = time / kSteps;
      for (int i = 0; i < kSteps; ++i) {  // Runge, Kutta and Nystroem
        const double k1 = acceleration(at.position);
        const double k2 = acceleration(at.position + 0.5 * step * at.velocity + 0.125 * step * step * k1);
        const double k3 = acceleration(at.position + step * at.velocity + 0.5 * step * step * k2);
        at.position += step * at.velocity + step * step / 6.0 * (k1 + 2.0 * k2);
        at.velocity += step / 6.0 * (k1 + 4.0 * k2 + k3);
      }
      at.time = time + 1.0;
      at.acceleration = acceleration(at.position);
      return at;
    };
    return NeededTorque(torque, Interpolant({knot(0.0), knot(h)})).range().length();
  };
  EXPECT_LE(width(0.02), 1e-7);
  EXPECT_NEAR(width(0.04) / width(0.02), 16.0, 2.0);
}

TEST(NeededTorque, OfAnArmThatStandsStillIsOneNumber) {
  const JointTorque torque(arm_with(2.0, 5.0, 3.0));
  const NeededTorque needed(torque, Interpolant({{0.0, 1.1, 0.0, 0.0, 0.0}, {1000.0, 1.1, 0.0, 0.0, 0.0}}));
  EXPECT_EQ(needed.range().lower, torque.at({1.1, 0.0}, 0.0));
  EXPECT_EQ(needed.range().upper, torque.at({1.1, 0.0}, 0.0));
  EXPECT_EQ(needed.departures_from_chord()[0], 0.0);
}

TEST(NeededTorque, ProvesNothingOfNumbersThatOverflow) {
  const JointTorque torque(arm_with(2.0, 5.0, 0.0));
  for (const double huge : {1e300, 1e200}) {
    for (const bool is_first : {true, false}) {
      SCOPED_TRACE(testing::Message() << huge << " " << is_first);
      std::vector<Knot> knots = {{0.0, 0.1, 0.0, 0.0, 0.0}, {0.1, 0.1, 0.0, 0.0, 0.0}, {0.2, 0.1, 0.0, 0.0, 0.0}};
      knots.push_back({0.2 + 1e-9, is_first ? huge : 0.1, is_first ? 0.0 : huge, 0.0, 0.0});
      const Interpolant motion(knots);
      const NeededTorque needed(torque, motion);
      EXPECT_FALSE(std::isfinite(needed.range().upper));
      EXPECT_FALSE(std::isfinite(needed.range(2).upper));
      EXPECT_FALSE(std::isfinite(needed.departures_from_chord()[2]));
      EXPECT_TRUE(std::isfinite(needed.range(0).upper));
    }
  }
}

}  // namespace
}  // namespace dualarm
