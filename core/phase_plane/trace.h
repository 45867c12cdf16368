#pragma once

#include <vector>

#include "core/model/problem.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// An extremal arc integrated in time, for limits that depend on the velocity. It is kept as nodes from which every
/// state in between is one step of the integration away, so that nothing is lost to interpolation. Theory, section 1.1.
class Trace {
 public:
  struct Node {
    double time = 0.0;  ///< s since the first node; falls where the integration runs backward in time
    JointState state;
    bool at_bend = false;  ///< the accelerations have a bend here
  };

  /// Why it ended.
  enum class Stop {
    kArrived,  ///< at the position asked for
    kLimit,    ///< at the speed limit
    kRest,     ///< at rest before the position, or creeping towards rest for ever
  };

  /// From `from` with an end of the accelerations, forward (time_sign = 1) or backward (-1) in time, until the position
  /// is `until`, the speed exceeds `speed_limit` or vanishes. `until` lies on the side the motion goes to; from rest,
  /// that is where the acceleration (backward as well as forward in time) drives it.
  Trace(const System& system, Extreme extreme, JointState from, double time_sign, double until, double speed_limit);

  Stop stop() const { return stop_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  const Node& end() const { return nodes_.back(); }

  /// The node at a position between the first node and the end.
  Node at_position(double position) const;

  /// The state at a time between the first node's and the end's.
  JointState at_time(double time) const;

 private:
  JointState advanced(const JointState& state, double step) const;
  double acceleration(const JointState& state) const;
  Node located(const Node& node, double step, double target, double JointState::*what) const;
  Node up_to_turn_of_speed(const Node& next) const;
  bool is_over_limit(const Node& node) const;
  bool halves_agree(double way, double speed) const;
  bool looks_over_bend(const Node& from, const Node& to) const;
  bool accept(Node next);
  void end_where_slowest();

  const System* system_;
  Extreme extreme_;
  double until_;
  double speed_limit_;
  Stop stop_ = Stop::kArrived;
  std::vector<double> position_bends_;
  std::vector<double> velocity_bends_;
  std::vector<Node> nodes_;
};

}  // namespace dualarm
