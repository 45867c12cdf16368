#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/model/trajectory.h"
#include "core/phase_plane/integral_series.h"
#include "core/phase_plane/system.h"
#include "core/phase_plane/trace.h"

namespace dualarm {

/// Position and time along one arc, on the arc's own clock from 0 to duration(): by quadrature where work and energy
/// give the speed, else along an integrated trace. Refers to the system, which has to outlive it.
class ArcMotion {
 public:
  /// The kind and the end states of `arc` count, its times do not. Precondition: it has some length, or changes its
  /// velocity, and does not turn back; but an end velocity whose stopping distance positions cannot tell may point
  /// against it.
  ArcMotion(const System& system, const Arc& arc) : ArcMotion(system, arc, kExact) {}

  /// With times whose quadratures, where they have to subdivide, stop at a relative difference of two rules.
  ArcMotion(const System& system, const Arc& arc, double tolerance);

  /// Such differences: a digit above rounding; and one at which times hold to 1e-9, which takes half the work.
  static constexpr double kExact = 1e-13;
  static constexpr double kLean = 1e-9;

  /// Prepares for many questions about times, which a series then answers in a tenth of the time.
  void expect_questions();

  double duration() const { return duration_; }  ///< s

  /// The end of the admissible accelerations that is the arc's rule; nothing for a cruise.
  std::optional<Extreme> extreme() const { return kind_ == ArcKind::kCruise ? std::nullopt : std::optional(extreme_); }

  /// Acceleration (rad/s2) of the arc's rule in a state; 0 for a cruise.
  double acceleration(JointState state) const;

  /// Time (s) at which a position of the arc is passed.
  double time_at(double position) const;

  /// Velocity (rad/s) with which a position of the arc is passed.
  double velocity_at(double position) const;

  /// State at a time.
  JointState at(double time) const;

  /// States at `count` + 1 evenly spaced times from start to end. Of arcs so short that the rounding of their ends
  /// would show as acceleration, the last or the first one is some last digits off the end. In arc_states.cc.
  std::vector<JointState> states(int count) const;

 private:
  bool is_uniform() const;
  double mean_over_time() const;
  void take_anchor(double direction, bool is_traced);
  bool is_lost() const;
  bool slow_end_is_unsure(double direction) const;
  bool errors_fade_forward() const;
  double time_from_anchor(double position) const;
  double first_root() const;
  double last_root() const;
  double quadrature(double root) const;
  double change_at(double root) const;
  double slowness_near_anchor(double root) const;
  double speed_squared(double change) const;
  JointState from_anchor(double time) const;
  std::vector<JointState> along_series(const JointState& from, double step, int count) const;
  std::vector<JointState> integrated(const JointState& from, double step, int count, int parts) const;
  double miss(const JointState& state, const JointState& end) const;
  bool may_leave_miss(const JointState& state, const JointState& end) const;
  static void spread_miss(std::vector<JointState>& states, const JointState& end, double span);
  std::optional<std::vector<JointState>> met_halfway(std::vector<JointState> forward,
                                                     std::vector<JointState> backward) const;

  const System* system_;
  double tolerance_;
  ArcKind kind_;
  JointState start_;
  JointState end_;
  Extreme extreme_;
  std::optional<double> mean_acceleration_;  ///< rad/s2, of an arc so short that it does not change
  JointState anchor_;             ///< the end of the arc from which times are taken, as a rule the slower one
  double away_;                   ///< sign of position - anchor along the arc
  bool from_start_ = true;        ///< the anchor is the arc's start
  std::optional<SineWork> work_;  ///< from the anchor on, where it is that simple
  std::optional<Trace> trace_;    ///< from the anchor, where velocity enters
  std::shared_ptr<const IntegralSeries> clock_;  ///< the quadrature, from the first root on
  double virtual_rest_ = 0.0;  ///< rad, how far behind the anchor its speed would have been gained from rest
  double backlash_ = 0.0;      ///< s, to stop at the anchor where its tiny velocity points against the arc
  double duration_;
};

}  // namespace dualarm
