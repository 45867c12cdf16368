#pragma once

#include <vector>

#include "core/model/arm.h"
#include "core/model/problem.h"
#include "core/phase_plane/system.h"

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
  Interval acceleration_bounds() const override;
  bool velocity_matters(Extreme extreme, double direction) const override;
  bool drives_best_at_rest(double direction) const override;
  double specific_work(Extreme extreme, double from, double change) const override;
  std::vector<double> zeros(Extreme extreme, double s_dot, Interval within) const override;
  std::vector<double> position_bends(Interval within) const override;
  std::vector<double> velocity_bends() const override;
  double stiffness() const override;

  /// Torque (N m) the drive has to give in a state for an acceleration (rad/s2).
  double torque(JointState state, double acceleration) const;

 private:
  double limit(Extreme extreme) const { return extreme == Extreme::kLowest ? torque_.lower : torque_.upper; }

  double inertia_;
  double friction_;
  GravityTorque gravity_;
  Interval torque_;
  Interval range_;
  Interval velocity_;
};

}  // namespace dualarm
