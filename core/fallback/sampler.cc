#include "core/fallback/sampler.h"

#include <numbers>

namespace dualarm {
namespace {

/// How often an arm is drawn in one of its preferred states, and how often it is in motion elsewhere.
constexpr double kPreferredShare = 0.25;
constexpr double kMotionShare = 0.3;

}  // namespace

void Sampler::sampleUniform(ompl::base::State* state) {
  const auto* space = space_->as<StateTimeSpace>();
  JointStates states;
  for (int arm = 0; arm < kArmCount; ++arm) {
    const std::vector<JointState>& preferred = preferred_[arm];
    if (!preferred.empty() && random_.chance(kPreferredShare)) {
      states[arm] = preferred[random_.below(static_cast<int>(preferred.size()))];
    } else {
      states[arm].position = random_.in(space->systems()[arm]->range());
      if (random_.chance(kMotionShare)) states[arm].velocity = random_.in(space->speeds(arm));
    }
  }
  StateTimeSpace::set(state, states, random_.in({0.0, space->getMaximumExtent()}));
}

void Sampler::sampleUniformNear(ompl::base::State* state, const ompl::base::State* near, double distance) {
  JointStates states = StateTimeSpace::states(near);
  for (JointState& joint : states) {
    joint.position += random_.in({-distance, distance});
    joint.velocity += random_.in({-distance, distance});
  }
  StateTimeSpace::set(state, states, StateTimeSpace::time(near) + random_.in({-distance, distance}));
  space_->enforceBounds(state);
}

void Sampler::sampleGaussian(ompl::base::State* state, const ompl::base::State* mean, double standard_deviation) {
  sampleUniformNear(state, mean, std::numbers::sqrt3 * standard_deviation);
}

}  // namespace dualarm
