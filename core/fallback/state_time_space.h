#pragma once

#include <ompl/base/StateSpace.h>

#include <cstdint>
#include <limits>

#include "core/fallback/steering.h"

namespace dualarm {

/// Both arms at rest at a time, as an OMPL space: (theta1, theta2) in rad and t in s, bounded by the joint ranges and a
/// horizon. Theory, section 6, with velocities zero.
///
/// Its distance is time and has a direction: t' - t if the later state can be reached from the earlier one by both
/// arms' fastest motions, infinite otherwise (into the past, or too soon). Bodies do not matter to it. Interpolation is
/// straight in all three coordinates: motions between states are the MotionValidator's matter, not the space's.
class StateTimeSpace final : public ompl::base::CompoundStateSpace {
 public:
  /// `horizon` s, > 0; `seed` is of the samplers that the space hands out: all begin the same sequence. `settled_time`
  /// (s, perhaps minus infinite): after it no object moves by itself, so that nobody has to wait for one.
  StateTimeSpace(const Systems& systems, double horizon, std::uint64_t seed,
                 double settled_time = -std::numeric_limits<double>::infinity());

  const Systems& systems() const { return systems_; }

  /// A time (s) to wait for at a sampled state, spread evenly from 0 to the settled time; minus infinity where nothing
  /// moves by itself.
  double worth_waiting_for(const ompl::base::State* sample) const;

  static JointPair positions(const ompl::base::State* state);
  static double time(const ompl::base::State* state);
  static void set(ompl::base::State* state, const JointPair& positions, double time);

  double distance(const ompl::base::State* from, const ompl::base::State* to) const override;
  double getMaximumExtent() const override;
  bool isMetricSpace() const override { return false; }
  bool hasSymmetricDistance() const override { return false; }
  ompl::base::StateSamplerPtr allocDefaultStateSampler() const override;

 private:
  Systems systems_;
  double horizon_;
  double settled_time_;
  std::uint64_t seed_;
};

}  // namespace dualarm
