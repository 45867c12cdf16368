#include "core/systems/single_joint_arm.h"

#include <algorithm>
#include <cmath>

namespace dualarm {
namespace {

/// Appends base + k * period, for every whole k, as far as it lies in `within`.
void append_repeated(std::vector<double>& positions, double base, double period, Interval within) {
  const double first = base + period * std::ceil((within.lower - base) / period);
  const int count = first <= within.upper ? 1 + static_cast<int>((within.upper - first) / period) : 0;
  for (int k = 0; k < count; ++k) positions.push_back(first + k * period);
}

}  // namespace

SingleJointArm::SingleJointArm(const Arm& arm)
    : inertia_(arm.inertia),
      friction_(arm.viscous_friction),
      gravity_(arm.gravity),
      torque_(std::get<Interval>(arm.torque)),
      range_(arm.joint_range),
      velocity_(arm.velocity) {}

Interval SingleJointArm::acceleration(double s, double s_dot) const {
  const double held = gravity_.amplitude * std::sin(s - gravity_.phase) + friction_ * s_dot;
  return {(torque_.lower - held) / inertia_, (torque_.upper - held) / inertia_};
}

Interval SingleJointArm::acceleration_bounds() const {
  Interval bounds = acceleration(range_.lower, 0.0);
  const auto include = [&](double s) {
    const Interval here = acceleration(s, 0.0);
    bounds = {std::min(bounds.lower, here.lower), std::max(bounds.upper, here.upper)};
  };
  include(range_.upper);
  // Gravity is extreme a quarter of a turn from where the arm hangs, on either side.
  std::vector<double> quarters;
  append_repeated(quarters, gravity_.phase + 0.5 * std::numbers::pi, std::numbers::pi, range_);
  std::for_each(quarters.begin(), quarters.end(), include);
  return bounds;
}

double SingleJointArm::specific_work(Extreme extreme, double from, double change) const {
  // cos(b) - cos(a) as a product of sines: near rest the difference of cosines would lose all digits.
  const double cosine_change = -2.0 * std::sin(from + 0.5 * change - gravity_.phase) * std::sin(0.5 * change);
  return (limit(extreme) * change + gravity_.amplitude * cosine_change) / inertia_;
}

std::vector<double> SingleJointArm::zeros(Extreme extreme, double /*s_dot*/, Interval within) const {
  const double ratio = limit(extreme) / gravity_.amplitude;
  if (!(std::abs(ratio) < 1.0)) return {};
  std::vector<double> found;
  const double angle = std::asin(ratio);
  for (const double base : {gravity_.phase + angle, gravity_.phase + std::numbers::pi - angle}) {
    append_repeated(found, base, 2.0 * std::numbers::pi, within);
  }
  std::sort(found.begin(), found.end());
  return found;
}

bool SingleJointArm::velocity_matters(Extreme /*extreme*/, double /*direction*/) const { return friction_ > 0.0; }

bool SingleJointArm::drives_best_at_rest(double /*direction*/) const { return true; }

std::vector<double> SingleJointArm::position_bends(Interval /*within*/) const { return {}; }

std::vector<double> SingleJointArm::velocity_bends() const { return {}; }

double SingleJointArm::stiffness() const { return std::abs(gravity_.amplitude) / inertia_; }

double SingleJointArm::torque(JointState state, double acceleration) const {
  return inertia_ * acceleration + friction_ * state.velocity +
         gravity_.amplitude * std::sin(state.position - gravity_.phase);
}

}  // namespace dualarm
