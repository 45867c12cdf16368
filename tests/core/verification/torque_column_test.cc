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

/// One smooth swing of the paper's arm in `count` equal pieces of a single quintic, with the torques it needs.
std::vector<Knot> smooth_swing(const Arm& arm, int count) {
  const Quintic whole({0.0, 0.5, 0.0, 0.0, 0.0}, {1.5, 1.3, 0.0, 0.0, 0.0});
  std::vector<Knot> knots;
  for (int k = 0; k <= count; ++k) {
    const double t = 1.5 * k / count;
    Knot knot = {t, whole.derivative(0, t), whole.derivative(1, t), whole.derivative(2, t), 0.0};
    knot.torque = JointTorque(arm).at(knot.position, knot.acceleration);
    knots.push_back(knot);
  }
  return knots;
}

/// Largest departure in the first half of each piece of a drive that begins at its first knot and applies the torques.
double simulated_departure(const Arm& arm, const std::vector<Knot>& knots) {
  namespace odeint = boost::numeric::odeint;
  using State = std::array<double, 2>;
  double largest = 0.0;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const Knot& a = knots[k];
    const Knot& b = knots[k + 1];
    const Quintic piece(a, b);
    const auto motion = [&](const State& x, State& rate, double t) {
      const double torque = a.torque + (b.torque - a.torque) * (t - a.time) / (b.time - a.time);
      rate = {x[1], (torque - arm.gravity.amplitude * std::sin(x[0] - arm.gravity.phase)) / arm.inertia};
    };
    State state = {a.position, a.velocity};
    odeint::runge_kutta4<State> stepper;
    const double h = 0.5 * (b.time - a.time) / 100;
    for (int step = 0; step < 100; ++step) {
      stepper.do_step(motion, state, a.time + step * h, h);
      largest = std::max(largest, std::abs(state[0] - piece.derivative(0, a.time + (step + 1) * h)));
    }
  }
  return largest;
}

TEST(TorqueColumn, ThePositionErrorBoundsWhatADriveDoesAndNotByFar) {
  const Arm arm = paper_problem({30.0, 90.0}, {75.0, 90.0}).arms[0];
  for (const int count : {2, 5, 15, 50, 150}) {
    SCOPED_TRACE(count);
    const std::vector<Knot> knots = smooth_swing(arm, count);
    const TorqueColumnReport report = check_torque_column(arm, knots, Interpolant(knots));
    EXPECT_THAT(report.violations, testing::IsEmpty());
    const double simulated = simulated_departure(arm, knots);
    EXPECT_GE(report.max_position_error, simulated - 1e-13);
    if (count >= 15) {
      EXPECT_LE(report.max_position_error, 10.0 * simulated + 1e-12);
    }
  }
}

TEST(TorqueColumn, TheErrorFallsWithTheFourthPowerOfTheKnotPeriod) {
  const Arm arm = paper_problem({30.0, 90.0}, {75.0, 90.0}).arms[0];
  const auto error = [&](int count) {
    const std::vector<Knot> knots = smooth_swing(arm, count);
    return check_torque_column(arm, knots, Interpolant(knots)).max_position_error;
  };
  EXPECT_NEAR(error(50) / error(100), 16.0, 3.0);
}

TEST(TorqueColumn, ALongRestWithTheRightTorqueHasNoError) {
  const Problem problem = paper_problem({90.0, 90.0}, {90.0, 90.0});
  const std::vector<Knot> knots = resting_motion(problem, 1000.0)[0].knots;
  EXPECT_EQ(check_torque_column(problem.arms[0], knots, Interpolant(knots)).max_position_error, 0.0);
}

TEST(TorqueColumn, TheWorstKnotIsNamed) {
  const Arm arm = paper_problem({30.0, 90.0}, {75.0, 90.0}).arms[0];
  std::vector<Knot> knots = smooth_swing(arm, 15);
  knots[3].torque += 0.01;
  knots[7].torque += 0.02;
  const TorqueColumnReport report = check_torque_column(arm, knots, Interpolant(knots));
  ASSERT_EQ(report.violations.size(), 1u);
  EXPECT_EQ(report.violations[0].kind, ViolationKind::kTorqueColumn);
  EXPECT_EQ(report.violations[0].time, knots[7].time);
  EXPECT_NEAR(report.violations[0].value - report.violations[0].limit, 0.02, 1e-12);
  EXPECT_GE(report.max_position_error, simulated_departure(arm, knots));
}

}  // namespace
}  // namespace dualarm
