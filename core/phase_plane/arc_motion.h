#pragma once

#include <vector>

#include "core/model/trajectory.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// Position and time along one arc of a profile. Times are the arc's own (Arc::start_time .. end_time); end_time is not
/// used where the name says so. Both are references: do not outlive them.
class ArcMotion {
 public:
  ArcMotion(const System& system, const Arc& arc);

  /// Acceleration (rad/s2) of the arc's rule in a state; 0 for a cruise.
  double acceleration(JointState state) const;

  /// Time (s) from start to end by quadrature; does not use the arc's times.
  double duration() const;

  /// Time (s) at which a position of the arc is passed.
  double time_at(double position) const;

  /// State at a time of the arc.
  JointState at(double time) const;

  /// States at `count` + 1 evenly spaced times from start to end.
  std::vector<JointState> states(int count) const;

 private:
  double speed_near_anchor(double root) const;
  double time_from_anchor(double root) const;
  double speed_squared(double change) const;
  std::vector<JointState> integrated(const JointState& from, double step, int count, int parts) const;
  double miss(const JointState& state) const;
  void spread_miss(std::vector<JointState>& states) const;
  static std::vector<JointState> met_halfway(std::vector<JointState> forward, std::vector<JointState> backward);

  const System& system_;
  const Arc& arc_;
  Extreme extreme_ = Extreme::kHighest;
  JointState anchor_;       ///< the slower end of the arc: times are integrals from here
  double away_ = 1.0;       ///< sign of position - anchor along the arc
  bool from_start_ = true;  ///< the anchor is the arc's start
};

}  // namespace dualarm
