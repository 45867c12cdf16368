#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/model/problem.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// A system by its law alone: zeros are searched, work is summed up.
class Rig final : public System {
 public:
  using Law = std::function<Interval(double s, double s_dot)>;

  Rig(Interval range, Interval velocity, bool velocity_matters, Law law)
      : range_(range), velocity_(velocity), velocity_matters_(velocity_matters), law_(std::move(law)) {}

  Interval range() const override { return range_; }
  Interval velocity() const override { return velocity_; }
  Interval acceleration(double s, double s_dot) const override { return law_(s, s_dot); }
  Interval acceleration_bounds() const override {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  Interval acceleration_bounds(Interval /*velocities*/) const override { return acceleration_bounds(); }
  bool velocity_matters(Extreme, double) const override { return velocity_matters_; }
  bool drives_best_at_rest(double) const override { return false; }
  double specific_work(Extreme extreme, double from, double change) const override {
    constexpr int kParts = 2000;  // Simpson's error is below 1e-13 of what is summed
    const auto at = [&](int k) { return extreme_acceleration(extreme, from + change * k / kParts, 0.0); };
    double sum = at(0) + at(kParts);
    for (int k = 1; k < kParts; ++k) sum += (k % 2 == 1 ? 4.0 : 2.0) * at(k);
    return sum * change / (3.0 * kParts);
  }
  std::vector<double> zeros(Extreme extreme, double s_dot, Interval within) const override {
    constexpr int kCells = 997;
    std::vector<double> found;
    const auto value = [&](double s) { return extreme_acceleration(extreme, s, s_dot); };
    for (int k = 0; k < kCells; ++k) {
      double low = std::lerp(within.lower, within.upper, static_cast<double>(k) / kCells);
      double high = std::lerp(within.lower, within.upper, (k + 1.0) / kCells);
      if ((value(low) > 0.0) == (value(high) > 0.0)) continue;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        ((value(middle) > 0.0) == (value(low) > 0.0) ? low : high) = middle;
      }
      found.push_back(0.5 * (low + high));
    }
    return found;
  }
  std::vector<double> position_bends(Interval) const override { return {}; }
  std::vector<double> velocity_bends() const override { return {}; }
  double stiffness() const override { return std::numeric_limits<double>::infinity(); }

 private:
  Interval range_;
  Interval velocity_;
  bool velocity_matters_;
  Law law_;
};

/// I = 1: torque within +-torque, gravity G sin(s - phase), friction b.
inline Rig pendulum(double torque, double gravity, double phase, double friction, Interval range, Interval velocity) {
  return {range, velocity, friction > 0.0, [=](double s, double s_dot) -> Interval {
            const double held = gravity * std::sin(s - phase) + friction * s_dot;
            return {-torque - held, torque - held};
          }};
}

/// Where full braking from a state ends: in rest at a position, or (nothing) outside the range or the velocity limit.
/// At rest the sign of the velocity's zero is the direction. Classical Runge-Kutta, in steps of a 2000th of the time in
/// which the motion's scales change.
std::optional<double> braked_to_rest(const System& system, JointState from);

}  // namespace dualarm
