#include "core/fallback/state_time_space.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/TimeStateSpace.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "core/fallback/sampler.h"

namespace dualarm {
namespace {

namespace ob = ompl::base;

constexpr unsigned kJoints = 0;
constexpr unsigned kTime = 1;

/// rad: OMPL refuses bounds without an inside, so a joint that cannot move is given this much of it.
constexpr double kLeastRange = 1e-9;

/// s: rounding by which an arrival may seem earlier than the time it was computed from.
constexpr double kTimeRounding = 1e-12;

}  // namespace

StateTimeSpace::StateTimeSpace(const Systems& systems, double horizon, std::uint64_t seed, double settled_time)
    : systems_(systems), horizon_(horizon), settled_time_(settled_time), seed_(seed) {
  setName("StateTime");
  auto joints = std::make_shared<ob::RealVectorStateSpace>(kArmCount);
  ob::RealVectorBounds bounds(kArmCount);
  for (int arm = 0; arm < kArmCount; ++arm) {
    const Interval range = systems[arm]->range();
    bounds.setLow(arm, range.lower);
    bounds.setHigh(arm, std::max(range.upper, range.lower + kLeastRange));
  }
  joints->setBounds(bounds);
  auto time = std::make_shared<ob::TimeStateSpace>();
  time->setBounds(0.0, horizon);
  addSubspace(joints, 1.0);
  addSubspace(time, 1.0);
  lock();
}

JointPair StateTimeSpace::positions(const ob::State* state) {
  const auto* joints = state->as<ob::CompoundState>()->as<ob::RealVectorStateSpace::StateType>(kJoints);
  return {joints->values[0], joints->values[1]};
}

double StateTimeSpace::time(const ob::State* state) {
  return state->as<ob::CompoundState>()->as<ob::TimeStateSpace::StateType>(kTime)->position;
}

void StateTimeSpace::set(ob::State* state, const JointPair& positions, double time) {
  auto* compound = state->as<ob::CompoundState>();
  for (int arm = 0; arm < kArmCount; ++arm) {
    compound->as<ob::RealVectorStateSpace::StateType>(kJoints)->values[arm] = positions[arm];
  }
  compound->as<ob::TimeStateSpace::StateType>(kTime)->position = time;
}

double StateTimeSpace::worth_waiting_for(const ob::State* sample) const {
  return settled_time_ > 0.0 ? settled_time_ * time(sample) / horizon_ : -std::numeric_limits<double>::infinity();
}

double StateTimeSpace::distance(const ob::State* from, const ob::State* to) const {
  const double available = time(to) - time(from);
  const bool causal =
      available >= 0.0 && available + kTimeRounding >= monotone_time(systems_, positions(from), positions(to));
  return causal ? available : std::numeric_limits<double>::infinity();
}

double StateTimeSpace::getMaximumExtent() const { return horizon_; }

ob::StateSamplerPtr StateTimeSpace::allocDefaultStateSampler() const { return std::make_shared<Sampler>(this, seed_); }

}  // namespace dualarm
