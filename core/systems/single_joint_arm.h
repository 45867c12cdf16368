#pragma once

#include <vector>

#include "core/model/arm.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// One arm with one joint under gravity and constant torque limits: I theta'' = tau - G sin(theta - phi).
/// Theory, section 1 [paper, eqs. 1-4].
class SingleJointArm final : public System {
 public:
  /// `arm` with all that it carries included (loaded_arm). Precondition: inertia > 0, torque.lower < torque.upper.
  explicit SingleJointArm(const Arm& arm);

  Interval range() const override { return range_; }
  Interval acceleration(double s) const override;
  Interval acceleration_bounds() const override;
  Interval velocity() const override { return velocity_; }
  double specific_work(Extreme extreme, double from, double change) const override;
  std::vector<double> zeros(Extreme extreme, Interval within) const override;

  /// Torque (N m) the drive has to give at a position (rad) for an acceleration (rad/s2).
  double torque(double position, double acceleration) const;

 private:
  double limit(Extreme extreme) const { return extreme == Extreme::kLowest ? torque_.lower : torque_.upper; }

  double inertia_;
  GravityTorque gravity_;
  Interval torque_;
  Interval range_;
  Interval velocity_;
};

}  // namespace dualarm
