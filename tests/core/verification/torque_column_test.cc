#include "core/verification/torque_column.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "core/verification/joint_torque.h"
#include "tests/core/verification/sample_motions.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

TorqueColumnReport column_of(const Arm& arm, const std::vector<Knot>& knots) {
  const Interpolant motion(knots);
  const JointTorque torque(arm);
  return check_torque_column(arm, knots, torque, NeededTorque(torque, motion), motion);
}

/// One smooth swing of the paper's arm in `count` equal pieces of a single quintic, with the torques it needs.
std::vector<Knot> smooth_swing(const Arm& arm, int count) {
  const Quintic whole({0.0, 0.5, 0.0, 0.0, 0.0}, {1.5, 1.3, 0.0, 0.0, 0.0});
  std::vector<Knot> knots;
  for (int k = 0; k <= count; ++k) {
    const double t = 1.5 * k / count;
    Knot knot = {t, whole.derivative(0, t), whole.derivative(1, t), whole.derivative(2, t), 0.0};
    knot.torque = JointTorque(arm).at({knot.position, knot.velocity}, knot.acceleration);
    knots.push_back(knot);
  }
  return knots;
}

/// Largest departure from a piece of a drive that is in the state of one of its knots, for a share of the time to the
/// other one; from the second one with time run backwards.
double departure_from(const Arm& arm, const Knot& a, const Knot& b, bool from_first, double share) {
  using State = std::array<double, 2>;
  const Quintic piece(a, b);
  const auto motion = [&](const State& x, State& rate, double t) {
    const double torque = a.torque + (b.torque - a.torque) * (t - a.time) / (b.time - a.time);
    const double held = arm.gravity.amplitude * std::sin(x[0] - arm.gravity.phase) + arm.viscous_friction * x[1];
    rate = {x[1], (torque - held) / arm.inertia};
  };
  boost::numeric::odeint::runge_kutta4<State> stepper;
  const Knot& from = from_first ? a : b;
  State state = {from.position, from.velocity};
  constexpr int kSteps = 200;
  const double h = (from_first ? share : -share) * (b.time - a.time) / kSteps;
  double largest = 0.0;
  for (int step = 0; step < kSteps; ++step) {
    stepper.do_step(motion, state, from.time + step * h, h);
    largest = std::max(largest, std::abs(state[0] - piece.derivative(0, from.time + (step + 1) * h)));
  }
  return largest;
}

/// Largest departure of a drive that passes through the states of all knots: whatever it does between two, it is as far
/// as from the nearer knot, and as far as from the first.
double simulated_departure(const Arm& arm, const std::vector<Knot>& knots) {
  double largest = 0.0;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const Knot& a = knots[k];
    const Knot& b = knots[k + 1];
    const double from_nearer = std::max(departure_from(arm, a, b, true, 0.5), departure_from(arm, a, b, false, 0.5));
    largest = std::max(largest, std::min(from_nearer, departure_from(arm, a, b, true, 1.0)));
  }
  return largest;
}

TEST(TorqueColumn, ThePositionErrorBoundsWhatADriveDoesAndNotByFar) {
  const Arm arm = paper_problem({30.0, 90.0}, {75.0, 90.0}).arms[0];
  for (const int count : {2, 5, 15, 50, 150}) {
    SCOPED_TRACE(count);
    const std::vector<Knot> knots = smooth_swing(arm, count);
    const TorqueColumnReport report = column_of(arm, knots);
    EXPECT_THAT(report.violations, testing::IsEmpty());
    const double simulated = simulated_departure(arm, knots);
    EXPECT_GE(report.max_position_error, simulated - 1e-13);
    if (count >= 15) {
      EXPECT_LE(report.max_position_error, 10.0 * simulated + 1e-12);
    }
  }
}

TEST(TorqueColumn, ThePositionErrorBoundsWhatADriveWithFrictionDoesAndNotByFar) {
  for (const double friction : {1.0, 20.0, 400.0, 4000.0}) {
    Arm arm = paper_problem({30.0, 90.0}, {75.0, 90.0}).arms[0];
    arm.viscous_friction = friction;
    arm.torque = Interval{-1e5, 1e5};
    for (const int count : {2, 5, 15, 50, 150}) {
      SCOPED_TRACE(testing::Message() << friction << " N m s, " << count);
      std::vector<Knot> knots = smooth_swing(arm, count);
      EXPECT_THAT(column_of(arm, knots).violations, testing::IsEmpty());
      for (Knot& knot : knots) knot.torque += 0.01;
      const double bound = column_of(arm, knots).max_position_error;
      const double simulated = simulated_departure(arm, knots);
      EXPECT_GE(bound, simulated - 1e-13);
      if (count >= 50) {
        EXPECT_LE(bound, 10.0 * simulated + 1e-12);
      }
    }
  }
}

TEST(TorqueColumn, FrictionThatDrivesBackwardsInTimeIsCounted) {
  for (const double exponent : {0.1, 1.0, 1.5}) {  // b h / (2 I): e to this is what friction does from the second knot
    SCOPED_TRACE(exponent);
    Arm arm = paper_problem({30.0, 90.0}, {75.0, 90.0}).arms[0];
    arm.gravity = {};
    constexpr double kDuration = 0.5;
    arm.viscous_friction = 2.0 * exponent * arm.inertia / kDuration;
    const std::vector<Knot> knots = {{0.0, 1.0, 0.0, 0.0, 2.0}, {kDuration, 1.0, 0.0, 0.0, 2.0}};
    const double bound = column_of(arm, knots).max_position_error;
    const double simulated = simulated_departure(arm, knots);
    EXPECT_GE(bound, simulated);
    EXPECT_LE(bound, std::exp(exponent) * simulated);
    EXPECT_GT(simulated, 2.0 * kDuration * kDuration / (8.0 * arm.inertia)) << "more than without friction";
  }
}

TEST(TorqueColumn, TheErrorFallsWithTheFourthPowerOfTheKnotPeriod) {
  const Arm arm = paper_problem({30.0, 90.0}, {75.0, 90.0}).arms[0];
  const auto error = [&](int count) {
    const std::vector<Knot> knots = smooth_swing(arm, count);
    return column_of(arm, knots).max_position_error;
  };
  EXPECT_NEAR(error(50) / error(100), 16.0, 3.0);
}

TEST(TorqueColumn, ALongRestWithTheRightTorqueHasNoError) {
  const Problem problem = paper_problem({90.0, 90.0}, {90.0, 90.0});
  const std::vector<Knot> knots = resting_motion(problem, 1000.0)[0].knots;
  EXPECT_EQ(column_of(problem.arms[0], knots).max_position_error, 0.0);
}

TEST(TorqueColumn, TheWorstKnotIsNamed) {
  const Arm arm = paper_problem({30.0, 90.0}, {75.0, 90.0}).arms[0];
  std::vector<Knot> knots = smooth_swing(arm, 15);
  knots[3].torque += 0.01;
  knots[7].torque += 0.02;
  const TorqueColumnReport report = column_of(arm, knots);
  ASSERT_EQ(report.violations.size(), 1u);
  EXPECT_EQ(report.violations[0].kind, ViolationKind::kTorqueColumn);
  EXPECT_EQ(report.violations[0].time, knots[7].time);
  EXPECT_NEAR(report.violations[0].value - report.violations[0].limit, 0.02, 1e-12);
  EXPECT_GE(report.max_position_error, simulated_departure(arm, knots));
}

}  // namespace
}  // namespace dualarm
