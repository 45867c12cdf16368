#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/model/arm.h"
#include "core/model/problem.h"
#include "core/model/trajectory.h"
#include "core/phase_plane/system.h"
#include "core/systems/piecewise_linear.h"

namespace dualarm {

/// One arm with one joint under gravity, viscous friction and any torque limit:
/// I theta'' = tau - G sin(theta - phi) - b theta'.
/// Theory, section 1 [paper, eqs. 1-4].
class SingleJointArm final : public System {
 public:
  /// `arm` with all that it carries included (loaded_arm). Precondition: inertia > 0, and the torque limit valid.
  explicit SingleJointArm(const Arm& arm);

  Interval range() const override { return range_; }
  Interval velocity() const override { return velocity_; }
  Interval acceleration(double s, double s_dot) const override;
  Interval acceleration_bounds() const override { return bounds_; }
  Interval acceleration_bounds(Interval velocities) const override;
  bool velocity_matters(Extreme extreme, double direction) const override {
    return velocity_matters_[index(extreme)][direction > 0.0 ? 1 : 0];
  }
  bool drives_best_at_rest(double direction) const override { return drives_best_at_rest_[direction > 0.0 ? 1 : 0]; }
  double specific_work(Extreme extreme, double from, double change) const override;
  std::optional<SineWork> work_from(Extreme extreme, double from) const override;
  std::vector<double> zeros(Extreme extreme, double s_dot, Interval within) const override;
  std::vector<double> position_bends(Interval within) const override;
  std::vector<double> velocity_bends() const override;

  /// An upper bound, and under limits that do not depend on the position the value itself: gravity's largest share and
  /// the limits' largest share, though they may fall to different positions.
  double stiffness() const override;

  /// Where the torque limit is constant.
  bool extremal_series(Extreme extreme, JointState from, std::span<double> way) const override;

  /// Upper bound on the sixth derivative of the position (rad/s6) along a motion under one end of the torque limit
  /// whose speeds (rad/s) and accelerations (rad/s2) are at most these; infinite where the limit is not constant.
  double most_sixth_derivative(double speed, double acceleration) const;

  /// What the drive does in a state.
  struct Drive {
    double acceleration = 0.0;  ///< rad/s2
    double torque = 0.0;        ///< N m
    double span = 0.0;          ///< rad/s2, between the lowest and the highest acceleration
  };

  /// With an end of the torque limit, or, where none is named, at constant velocity.
  Drive drive(std::optional<Extreme> extreme, JointState state) const;

  /// The same at knots whose states follow each other closely, as those along a motion do, to 1e-15 of gravity's
  /// torque: fills in their accelerations and torques.
  void drive(std::optional<Extreme> extreme, std::span<Knot> knots) const;

  /// Torque (N m) the drive has to give in a state for an acceleration (rad/s2).
  double torque(JointState state, double acceleration) const;

 private:
  std::array<bool, 2> velocity_dependence(Extreme extreme) const;
  double extreme_bound(Extreme extreme, Interval velocities) const;
  double rest_bound(Extreme extreme, double over_velocities) const;
  double rubbed_off(double s_dot) const { return friction_ == 0.0 ? 0.0 : friction_ * s_dot; }  // 0 times infinity is 0
  bool drive_together(std::optional<Extreme> extreme, std::span<Knot> knots) const;
  static std::size_t index(Extreme extreme) { return extreme == Extreme::kLowest ? 0 : 1; }

  double inertia_;
  double friction_;
  GravityTorque gravity_;
  TorqueLimit torque_;
  Interval range_;
  Interval velocity_;
  std::array<PiecewiseLinear, 2> at_rest_;               ///< ends of the torque limit at standstill over s
  std::array<std::array<bool, 2>, 2> velocity_matters_;  ///< by end and direction
  std::array<bool, 2> drives_best_at_rest_;              ///< by direction
  Interval bounds_;
  Interval rest_bounds_;
};

}  // namespace dualarm
