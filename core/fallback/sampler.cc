#include "core/fallback/sampler.h"

#include <numbers>

namespace dualarm {
namespace {

/// How often a joint is drawn from its preferred positions.
constexpr double kPreferredShare = 0.25;

}  // namespace

void Sampler::sampleUniform(ompl::base::State* state) {
  const auto* space = space_->as<StateTimeSpace>();
  JointPair positions;
  for (int arm = 0; arm < kArmCount; ++arm) {
    const std::vector<double>& preferred = preferred_[arm];
    if (!preferred.empty() && random_.chance(kPreferredShare)) {
      positions[arm] = preferred[random_.below(static_cast<int>(preferred.size()))];
    } else {
      positions[arm] = random_.in(space->systems()[arm]->range());
    }
  }
  StateTimeSpace::set(state, positions, random_.in({0.0, space->getMaximumExtent()}));
}

void Sampler::sampleUniformNear(ompl::base::State* state, const ompl::base::State* near, double distance) {
  JointPair positions = StateTimeSpace::positions(near);
  for (double& position : positions) position += random_.in({-distance, distance});
  StateTimeSpace::set(state, positions, StateTimeSpace::time(near) + random_.in({-distance, distance}));
  space_->enforceBounds(state);
}

void Sampler::sampleGaussian(ompl::base::State* state, const ompl::base::State* mean, double standard_deviation) {
  sampleUniformNear(state, mean, std::numbers::sqrt3 * standard_deviation);
}

}  // namespace dualarm
