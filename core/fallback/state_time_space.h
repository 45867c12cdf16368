#pragma once

#include <ompl/base/StateSpace.h>

#include <cstdint>
#include <limits>

#include "core/fallback/steering.h"

namespace dualarm {

/// Both arms' states at a time, as an OMPL space: (theta1, theta2) in rad, (omega1, omega2) in rad/s and t in s,
/// bounded by the joint ranges, by speeds and by a horizon. Theory, section 6.
///
/// Its distance is time and has a direction: t' - t if either arm can get from the earlier state to the later one in
/// that time, infinite otherwise (into the past, or too soon). Bodies do not matter to it. Interpolation is straight in
/// all coordinates: motions between states are the MotionValidator's matter, not the space's.
class StateTimeSpace final : public ompl::base::CompoundStateSpace {
 public:
  /// `horizon` s, > 0; `seed` is of the samplers that the space hands out: all begin the same sequence. `settled_time`
  /// (s, perhaps minus infinite): after it no object moves by itself, so that nobody has to wait for one. `ends`:
  /// states that have to lie inside.
  StateTimeSpace(const Systems& systems, double horizon, std::uint64_t seed,
                 double settled_time = -std::numeric_limits<double>::infinity(),
                 const std::array<JointStates, 2>& ends = {});

  const Systems& systems() const { return systems_; }

  /// Velocities (rad/s) of an arm in this space: its limits, and where these are wide what its drive gives over its
  /// range.
  Interval speeds(int arm) const { return speeds_[arm]; }

  /// s: how long states that differ take from each other by speed and drive alone, roughly and whichever way. A metric,
  /// for finding what is near.
  double difference(const JointStates& from, const JointStates& to) const;

  /// No state later than `horizon` (s) is of any use any more.
  void shrink(double horizon);

  /// A time (s) to wait for at a sampled state, spread evenly from 0 to the settled time; minus infinity where nothing
  /// moves by itself.
  double worth_waiting_for(const ompl::base::State* sample) const;

  static JointStates states(const ompl::base::State* state);
  static double time(const ompl::base::State* state);
  static void set(ompl::base::State* state, const JointStates& states, double time);

  double distance(const ompl::base::State* from, const ompl::base::State* to) const override;
  double getMaximumExtent() const override;
  bool isMetricSpace() const override { return false; }
  bool hasSymmetricDistance() const override { return false; }
  ompl::base::StateSamplerPtr allocDefaultStateSampler() const override;

 private:
  Systems systems_;
  std::array<Interval, kArmCount> speeds_;
  JointPair pace_;   ///< rad/s
  JointPair drive_;  ///< rad/s2
  double horizon_;
  double settled_time_;
  std::uint64_t seed_;
};

}  // namespace dualarm
