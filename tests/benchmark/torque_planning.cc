#include "tests/benchmark/torque_planning.h"

#include <ompl/base/goals/GoalState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/control/PathControl.h>
#include <ompl/control/SimpleSetup.h>
#include <ompl/control/planners/kpiece/KPIECE1.h>
#include <ompl/control/planners/rrt/RRT.h>
#include <ompl/control/planners/sst/SST.h>
#include <ompl/control/spaces/RealVectorControlSpace.h>
#include <ompl/util/Console.h>

#include <array>
#include <chrono>
#include <limits>

#include "core/fallback/clearance_proof.h"
#include "core/systems/single_joint_arm.h"

namespace dualarm {
namespace {

namespace ob = ompl::base;
namespace oc = ompl::control;

constexpr double kStep = 0.02;       // s, of controls and collision tests
constexpr int kSubsteps = 2;         // of the integration, in a step
constexpr unsigned kMostSteps = 25;  // that a control is kept
constexpr double kSlice = 0.02;      // s, after which solutions are looked at
constexpr double kClearance = 1e-4;  // m, the planning margin

using Numbers = std::array<double, 4>;  // theta1, theta2, omega1, omega2

/// Both arms under constant torques as shares of what their drives give.
class Dynamics {
 public:
  explicit Dynamics(const Problem& problem)
      : systems_{SingleJointArm(loaded_arm(problem, 0)), SingleJointArm(loaded_arm(problem, 1))} {}

  Numbers after(Numbers state, const double* shares, double duration) const {
    const int steps = std::max(1, static_cast<int>(duration / kStep + 0.5)) * kSubsteps;
    const double h = duration / steps;
    for (int i = 0; i < steps; ++i) {  // Heun's method: errors of 1e-5 rad here
      const Numbers first = rates(state, shares);
      Numbers ahead = state;
      for (int k = 0; k < 4; ++k) ahead[k] += h * first[k];
      const Numbers second = rates(ahead, shares);
      for (int k = 0; k < 4; ++k) state[k] += 0.5 * h * (first[k] + second[k]);
    }
    return state;
  }

 private:
  Numbers rates(const Numbers& state, const double* shares) const {
    Numbers rates = {state[2], state[3], 0.0, 0.0};
    for (int arm = 0; arm < kArmCount; ++arm) {
      const Interval admissible = systems_[arm].acceleration(state[arm], state[2 + arm]);
      rates[2 + arm] = admissible.lower + 0.5 * (1.0 + shares[arm]) * admissible.length();
    }
    return rates;
  }

  std::array<SingleJointArm, kArmCount> systems_;
};

Numbers numbers_of(const ob::State* state) {
  const double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  return {values[0], values[1], values[2], values[3]};
}

void put(const Numbers& numbers, ob::State* state) {
  for (int k = 0; k < 4; ++k) state->as<ob::RealVectorStateSpace::StateType>()->values[k] = numbers[k];
}

ob::StateSpacePtr state_space(const Problem& problem) {
  auto space = std::make_shared<ob::RealVectorStateSpace>(4);
  ob::RealVectorBounds bounds(4);
  for (int arm = 0; arm < kArmCount; ++arm) {
    bounds.setLow(arm, problem.arms[arm].joint_range.lower);
    bounds.setHigh(arm, problem.arms[arm].joint_range.upper);
    bounds.setLow(2 + arm, problem.arms[arm].velocity.lower);
    bounds.setHigh(2 + arm, problem.arms[arm].velocity.upper);
  }
  space->setBounds(bounds);
  return space;
}

ob::PlannerPtr make(TorquePlanner planner, const oc::SpaceInformationPtr& space) {
  switch (planner) {
    case TorquePlanner::kRrt:
      return std::make_shared<oc::RRT>(space);
    case TorquePlanner::kKpiece:
      return std::make_shared<oc::KPIECE1>(space);
    case TorquePlanner::kSst:
      return std::make_shared<oc::SST>(space);
  }
  return nullptr;
}

}  // namespace

const char* name_of(TorquePlanner planner) {
  switch (planner) {
    case TorquePlanner::kRrt:
      return "RRT";
    case TorquePlanner::kKpiece:
      return "KPIECE1";
    case TorquePlanner::kSst:
      return "SST";
  }
  return "";
}

void plan_by_torques(const Problem& problem, TorquePlanner planner, double seconds,
                     const std::function<void(double, double)>& on_better) {
  ompl::msg::noOutputHandler();
  const Budget unlimited;
  const ClearanceProof proof(problem, problem.options.clearance + kClearance, unlimited);
  const Dynamics dynamics(problem);
  const ob::StateSpacePtr states = state_space(problem);
  auto controls = std::make_shared<oc::RealVectorControlSpace>(states, kArmCount);
  ob::RealVectorBounds shares(kArmCount);
  shares.setLow(-1.0);
  shares.setHigh(1.0);
  controls->setBounds(shares);

  oc::SimpleSetup setup(controls);
  const oc::SpaceInformationPtr& information = setup.getSpaceInformation();
  setup.setStatePropagator([&](const ob::State* from, const oc::Control* control, double duration, ob::State* to) {
    put(dynamics.after(numbers_of(from), control->as<oc::RealVectorControlSpace::ControlType>()->values, duration), to);
  });
  setup.setStateValidityChecker([&](const ob::State* state) {
    const Numbers numbers = numbers_of(state);
    return information->satisfiesBounds(state) && proof.slack({numbers[0], numbers[1]}) > 0.0;
  });
  information->setPropagationStepSize(kStep);
  information->setMinMaxControlDuration(1, kMostSteps);
  ob::ScopedState<> start(states);
  ob::ScopedState<> goal(states);
  for (int arm = 0; arm < kArmCount; ++arm) {
    start[arm] = problem.tasks[arm].start.position;
    start[2 + arm] = problem.tasks[arm].start.velocity;
    goal[arm] = problem.tasks[arm].goal.position;
    goal[2 + arm] = problem.tasks[arm].goal.velocity;
  }
  setup.setStartAndGoalStates(start, goal, kGoalTolerance);
  setup.setPlanner(make(planner, information));
  setup.setup();

  const auto begin = std::chrono::steady_clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
  double best = std::numeric_limits<double>::infinity();
  while (passed() < seconds) {
    const double slice_end = std::min(seconds, passed() + kSlice);
    setup.getPlanner()->solve(ob::PlannerTerminationCondition([&] { return passed() >= slice_end; }));
    if (!setup.getProblemDefinition()->hasExactSolution()) continue;
    const double duration = setup.getSolutionPath().length();
    if (duration < best) on_better(passed(), duration);
    best = std::min(best, duration);
    if (planner != TorquePlanner::kSst) setup.clear();
  }
}

}  // namespace dualarm
