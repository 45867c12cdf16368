#include "core/fallback/state_time_space.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/TimeStateSpace.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/fallback/sampler.h"

namespace dualarm {
namespace {

namespace ob = ompl::base;

constexpr unsigned kJoints = 0;
constexpr unsigned kVelocities = 1;
constexpr unsigned kTime = 2;

/// rad: OMPL refuses bounds without an inside, so a joint that cannot move is given this much of it.
constexpr double kLeastRange = 1e-9;

/// s: rounding by which an arrival may seem earlier than the time it was computed from.
constexpr double kTimeRounding = 1e-11;

/// The larger acceleration (rad/s2) of an arm from standstill.
double drive_of(const System& system) {
  const Interval bounds = system.acceleration_bounds({0.0, 0.0});
  return std::max(-bounds.lower, bounds.upper);
}

/// What the drive gives over the whole range, inside the limits, and the end states' velocities.
Interval speeds_of(const System& system, const std::array<JointStates, 2>& ends, int arm) {
  const double most = std::sqrt(2.0 * drive_of(system) * std::max(system.range().length(), kLeastRange));
  const Interval limits = system.velocity();
  Interval speeds = {std::max(limits.lower, -most), std::min(limits.upper, most)};
  for (const JointStates& end : ends) {
    speeds.lower = std::min(speeds.lower, end[arm].velocity);
    speeds.upper = std::max(speeds.upper, end[arm].velocity);
  }
  return speeds;
}

/// s: OMPL refuses bounds without an inside.
constexpr double kLeastHorizon = 1e-9;

}  // namespace

StateTimeSpace::StateTimeSpace(const Systems& systems, double horizon, std::uint64_t seed, double settled_time,
                               const std::array<JointStates, 2>& ends)
    : systems_(systems), horizon_(horizon), settled_time_(settled_time), seed_(seed) {
  setName("StateTime");
  auto joints = std::make_shared<ob::RealVectorStateSpace>(kArmCount);
  auto velocities = std::make_shared<ob::RealVectorStateSpace>(kArmCount);
  ob::RealVectorBounds ranges(kArmCount);
  ob::RealVectorBounds limits(kArmCount);
  for (int arm = 0; arm < kArmCount; ++arm) {
    const Interval range = systems[arm]->range();
    speeds_[arm] = speeds_of(*systems[arm], ends, arm);
    pace_[arm] = 0.5 * speeds_[arm].length();
    drive_[arm] = drive_of(*systems[arm]);
    ranges.setLow(arm, range.lower);
    ranges.setHigh(arm, std::max(range.upper, range.lower + kLeastRange));
    limits.setLow(arm, speeds_[arm].lower);
    limits.setHigh(arm, speeds_[arm].upper);
  }
  joints->setBounds(ranges);
  velocities->setBounds(limits);
  auto time = std::make_shared<ob::TimeStateSpace>();
  time->setBounds(0.0, horizon);
  addSubspace(joints, 1.0);
  addSubspace(velocities, 1.0);
  addSubspace(time, 1.0);
  lock();
}

JointStates StateTimeSpace::states(const ob::State* state) {
  const auto* compound = state->as<ob::CompoundState>();
  const double* joints = compound->as<ob::RealVectorStateSpace::StateType>(kJoints)->values;
  const double* velocities = compound->as<ob::RealVectorStateSpace::StateType>(kVelocities)->values;
  return {JointState{joints[0], velocities[0]}, JointState{joints[1], velocities[1]}};
}

double StateTimeSpace::time(const ob::State* state) {
  return state->as<ob::CompoundState>()->as<ob::TimeStateSpace::StateType>(kTime)->position;
}

void StateTimeSpace::set(ob::State* state, const JointStates& states, double time) {
  auto* compound = state->as<ob::CompoundState>();
  for (int arm = 0; arm < kArmCount; ++arm) {
    compound->as<ob::RealVectorStateSpace::StateType>(kJoints)->values[arm] = states[arm].position;
    compound->as<ob::RealVectorStateSpace::StateType>(kVelocities)->values[arm] = states[arm].velocity;
  }
  compound->as<ob::TimeStateSpace::StateType>(kTime)->position = time;
}

double StateTimeSpace::difference(const JointStates& from, const JointStates& to) const {
  double largest = 0.0;
  for (int arm = 0; arm < kArmCount; ++arm) {
    largest = std::max(largest, std::abs(to[arm].position - from[arm].position) / pace_[arm] +
                                    std::abs(to[arm].velocity - from[arm].velocity) / drive_[arm]);
  }
  return largest;
}

void StateTimeSpace::shrink(double horizon) {
  horizon_ = std::min(horizon_, std::max(horizon, kLeastHorizon));
  as<ob::TimeStateSpace>(kTime)->setBounds(0.0, horizon_);
}

double StateTimeSpace::worth_waiting_for(const ob::State* sample) const {
  return settled_time_ > 0.0 ? settled_time_ * time(sample) / horizon_ : -std::numeric_limits<double>::infinity();
}

double StateTimeSpace::distance(const ob::State* from, const ob::State* to) const {
  const double available = time(to) - time(from);
  const bool causal =
      available >= 0.0 && available + kTimeRounding >= steering_time(systems_, states(from), states(to));
  return causal ? available : std::numeric_limits<double>::infinity();
}

double StateTimeSpace::getMaximumExtent() const { return horizon_; }

ob::StateSamplerPtr StateTimeSpace::allocDefaultStateSampler() const { return std::make_shared<Sampler>(this, seed_); }

}  // namespace dualarm
