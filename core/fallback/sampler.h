#pragma once

#include <ompl/base/StateSampler.h>

#include <array>
#include <cstdint>
#include <vector>

#include "core/fallback/random.h"
#include "core/fallback/state_time_space.h"

namespace dualarm {

/// Draws states of a StateTimeSpace with a generator of its own: OMPL's samplers share a process-wide one.
class Sampler final : public ompl::base::StateSampler {
 public:
  Sampler(const StateTimeSpace* space, std::uint64_t seed) : StateSampler(space), random_(seed) {}

  /// States that an arm is drawn in more often than elsewhere: where it starts and where it has to go, so that the
  /// other arm may move alone.
  void prefer(int arm, std::vector<JointState> states) { preferred_[arm] = std::move(states); }

  /// Even over positions and times; an arm is at rest more often than in motion.
  void sampleUniform(ompl::base::State* state) override;

  /// `distance` in rad for the joints, in rad/s for velocities and in s for the time.
  void sampleUniformNear(ompl::base::State* state, const ompl::base::State* near, double distance) override;

  /// Not a normal distribution: even over the interval of the same standard deviation.
  void sampleGaussian(ompl::base::State* state, const ompl::base::State* mean, double standard_deviation) override;

  /// The generator, for whoever draws more than states.
  Random& random() { return random_; }

 private:
  Random random_;
  std::array<std::vector<JointState>, kArmCount> preferred_;
};

}  // namespace dualarm
