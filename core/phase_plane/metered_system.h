#pragma once

#include "core/phase_plane/system.h"

namespace dualarm {

/// A system that counts what is asked of it, so that a search can stop after the same work on every machine. Refers to
/// the system it passes the questions to.
class MeteredSystem final : public System {
 public:
  explicit MeteredSystem(const System& system) : system_(system) {}

  long count() const { return count_; }  ///< accelerations, works and zeros so far

  Interval range() const override { return system_.range(); }
  Interval velocity() const override { return system_.velocity(); }
  Interval acceleration(double s, double s_dot) const override {
    ++count_;
    return system_.acceleration(s, s_dot);
  }
  Interval acceleration_bounds() const override { return system_.acceleration_bounds(); }
  Interval acceleration_bounds(Interval velocities) const override { return system_.acceleration_bounds(velocities); }
  bool velocity_matters(Extreme extreme, double direction) const override {
    return system_.velocity_matters(extreme, direction);
  }
  bool drives_best_at_rest(double direction) const override { return system_.drives_best_at_rest(direction); }
  double specific_work(Extreme extreme, double from, double change) const override {
    ++count_;
    return system_.specific_work(extreme, from, change);
  }
  std::vector<double> zeros(Extreme extreme, double s_dot, Interval within) const override {
    std::vector<double> found = system_.zeros(extreme, s_dot, within);
    count_ += static_cast<long>(found.size());
    return found;
  }
  std::vector<double> position_bends(Interval within) const override { return system_.position_bends(within); }
  std::vector<double> velocity_bends() const override { return system_.velocity_bends(); }
  bool extremal_series(Extreme extreme, JointState from, std::span<double> way) const override {
    ++count_;
    return system_.extremal_series(extreme, from, way);
  }
  double stiffness() const override { return system_.stiffness(); }

 private:
  const System& system_;
  mutable long count_ = 0;
};

}  // namespace dualarm
