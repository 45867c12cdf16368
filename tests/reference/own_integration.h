#pragma once

#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <functional>

#include "tests/reference/own_equation.h"

namespace dualarm {

/// Position (rad) and velocity (rad/s).
template <typename Real>
using OwnState = std::array<Real, 2>;

/// Integrates the arm under a share of its torque, 0 the smallest and 1 the largest, with adaptive steps: a step counts
/// when two halves of it end within `tolerance` (rad and rad/s) of it, so that bends of the limits are met by short
/// steps.
template <typename Real>
class OwnIntegration {
 public:
  OwnIntegration(const Arm& arm, double share, Real tolerance) : own_(arm), share_(share), tolerance_(tolerance) {}

  /// The state `time` s after (or before) another; `visit` sees the end of each step, with the time since the
  /// beginning.
  OwnState<Real> run(OwnState<Real> state, Real time, const std::function<void(const OwnState<Real>&, Real)>& visit) {
    constexpr int kParts = 8;
    for (int part = 0; part < kParts; ++part) {
      state = refined(state, stepped(state, time / kParts), time / kParts, time * part / kParts, visit, 0);
    }
    return state;
  }

 private:
  OwnState<Real> stepped(OwnState<Real> state, Real time) {
    stepper_.do_step(
        [this](const OwnState<Real>& at, OwnState<Real>& rate, Real) {
          rate = {at[1], acceleration(at)};
        },
        state, Real(0), time);
    return state;
  }

  OwnState<Real> refined(const OwnState<Real>& state, const OwnState<Real>& whole, Real time, Real begun,
                         const std::function<void(const OwnState<Real>&, Real)>& visit, int depth) {
    const OwnState<Real> half = stepped(state, time / 2);
    const OwnState<Real> halves = stepped(half, time / 2);
    const Real apart = std::max(std::abs(halves[0] - whole[0]), std::abs(halves[1] - whole[1]));
    const Real scale = std::max(Real(1), std::max(std::abs(state[0]), std::abs(state[1])));
    constexpr int kDeepest = 24;
    if (depth < kDeepest && apart > tolerance_ * scale) {
      const OwnState<Real> middle = refined(state, half, time / 2, begun, visit, depth + 1);
      return refined(middle, stepped(middle, time / 2), time / 2, begun + time / 2, visit, depth + 1);
    }
    visit(half, begun + time / 2);
    visit(halves, begun + time);
    return halves;
  }

  Real acceleration(const OwnState<Real>& at) const {
    if (share_ == 0.0) return own_.acceleration(-1, at[0], at[1]);
    if (share_ == 1.0) return own_.acceleration(+1, at[0], at[1]);
    const Real lowest = own_.acceleration(-1, at[0], at[1]);
    return lowest + Real(share_) * (own_.acceleration(+1, at[0], at[1]) - lowest);
  }

  OwnEquation<Real> own_;
  double share_;
  Real tolerance_;
  boost::numeric::odeint::runge_kutta_fehlberg78<OwnState<Real>, Real> stepper_;
};

}  // namespace dualarm
