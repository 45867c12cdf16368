#include "tests/reference/transcription_motion.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/reference/own_equation.h"

namespace dualarm {
namespace {

double torque_of(const Arm& arm, double share) {
  const Interval limits = std::get<Interval>(arm.torque);
  return 0.5 * (limits.lower + limits.upper) + 0.5 * share * limits.length();
}

double acceleration(const Arm& arm, JointState state, double torque) {
  return (torque - OwnEquation<double>(arm).holding_torque(state.position, state.velocity)) / arm.inertia;
}

JointState runge_kutta(const Arm& arm, JointState at, double torque, double h) {
  const auto moved = [&](JointState slope, double by) {
    return JointState{at.position + by * slope.position, at.velocity + by * slope.velocity};
  };
  const auto slope = [&](JointState state) { return JointState{state.velocity, acceleration(arm, state, torque)}; };
  const JointState k1 = slope(at);
  const JointState k2 = slope(moved(k1, 0.5 * h));
  const JointState k3 = slope(moved(k2, 0.5 * h));
  const JointState k4 = slope(moved(k3, h));
  return moved({k1.position + 2.0 * k2.position + 2.0 * k3.position + k4.position,
                k1.velocity + 2.0 * k2.velocity + 2.0 * k3.velocity + k4.velocity},
               h / 6.0);
}

}  // namespace

double Script::duration() const {
  return std::accumulate(stretches.begin(), stretches.end(), wait,
                         [](double sum, const Stretch& stretch) { return sum + stretch.duration; });
}

ScriptedMotion::ScriptedMotion(const Arm& arm, JointState start, const Script& script, int steps) {
  instants_.reserve(script.stretches.size() * (steps + 2) + 1);
  instants_.push_back({script.wait, start});
  for (const Stretch& stretch : script.stretches) {
    if (stretch.duration <= 0.0) continue;
    for (int i = 0; i < steps; ++i) step(arm, torque_of(arm, stretch.share), stretch.duration / steps);
  }
}

void ScriptedMotion::step(const Arm& arm, double torque, double duration) {
  const JointState from = instants_.back().state;
  const double drive = acceleration(arm, from, torque);
  const double limit = drive > 0.0 ? arm.velocity.upper : arm.velocity.lower;
  const int sense = drive > 0.0 ? 1 : -1;
  if (sense * from.velocity >= sense * limit) return cruise(arm, limit, duration);
  const JointState to = runge_kutta(arm, from, torque, duration);
  if (to.velocity <= arm.velocity.upper && to.velocity >= arm.velocity.lower) return push(duration, to);
  const double reached = to.velocity > arm.velocity.upper ? arm.velocity.upper : arm.velocity.lower;
  double until = duration * (reached - from.velocity) / (to.velocity - from.velocity);
  constexpr int kNewtonSteps = 4;  // from a chord that is nearly right already
  for (int i = 0; i < kNewtonSteps; ++i) {
    const JointState at = runge_kutta(arm, from, torque, until);
    until = std::clamp(until + (reached - at.velocity) / acceleration(arm, at, torque), 0.0, duration);
  }
  push(until, {runge_kutta(arm, from, torque, until).position, reached});
  cruise(arm, reached, duration - until);
}

void ScriptedMotion::cruise(const Arm& arm, double velocity, double duration) {
  push(duration, {instants_.back().state.position + velocity * duration, velocity});
  const double needed = OwnEquation<double>(arm).holding_torque(instants_.back().state.position, velocity);
  const Interval limits = std::get<Interval>(arm.torque);
  shortfall_ = std::max({shortfall_, needed - limits.upper, limits.lower - needed});
}

double ScriptedMotion::position_at(double time) const {
  if (time <= instants_.front().time) return instants_.front().state.position;
  if (time >= instants_.back().time) return instants_.back().state.position;
  const auto after = std::upper_bound(instants_.begin(), instants_.end(), time,
                                      [](double value, const Instant& instant) { return value < instant.time; });
  const auto before = after - 1;
  const double h = after->time - before->time;
  const double u = (time - before->time) / h;
  const double w = 1.0 - u;
  return w * w * (1.0 + 2.0 * u) * before->state.position + u * u * (1.0 + 2.0 * w) * after->state.position +
         u * w * h * (w * before->state.velocity - u * after->state.velocity);
}

Interval ScriptedMotion::swept() const {
  Interval all = {instants_.front().state.position, instants_.front().state.position};
  const auto widen = [&](double position) { all = {std::min(all.lower, position), std::max(all.upper, position)}; };
  for (std::size_t i = 1; i < instants_.size(); ++i) {
    widen(instants_[i].state.position);
    const double before = instants_[i - 1].state.velocity;
    const double after = instants_[i].state.velocity;
    if (before * after >= 0.0) continue;
    const double step = instants_[i].time - instants_[i - 1].time;
    widen(position_at(instants_[i - 1].time + step * before / (before - after)));
  }
  return all;
}

std::vector<Stretch> crude_move(const Arm& arm, double from, double to) {
  constexpr double kStep = 0.02;         // s, crude: the optimiser makes it exact
  constexpr double kLongestDrive = 4.0;  // s
  constexpr int kHalvings = 20;
  if (from == to) return {{0.0, 1.0}, {0.0, -1.0}};
  const double sense = to > from ? 1.0 : -1.0;
  // How long braking after a drive takes, and whether it ends beyond the target; < 0 if it never ends.
  const auto brake = [&](double drive, bool& is_beyond) {
    const int steps = 1 + static_cast<int>(drive / kStep);
    JointState state = ScriptedMotion(arm, {from, 0.0}, {0.0, {{drive, sense}}}, steps).end();
    double time = 0.0;
    is_beyond = sense * (state.position - to) > 0.0;
    while (sense * state.velocity > 0.0 && !is_beyond) {
      if (time > kLongestDrive) return -1.0;
      state = runge_kutta(arm, state, torque_of(arm, -sense), kStep);
      time += kStep;
      is_beyond = sense * (state.position - to) > 0.0;
    }
    return time;
  };
  double low = 0.0;
  double high = kLongestDrive;
  bool is_beyond = false;
  brake(high, is_beyond);
  if (!is_beyond) return {};
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    brake(middle, is_beyond);
    (is_beyond ? high : low) = middle;
  }
  const double braking = brake(low, is_beyond);
  if (braking < 0.0) return {};
  return {{low, sense}, {braking, -sense}};
}

double holding_share(const Arm& arm, double position) {
  const Interval limits = std::get<Interval>(arm.torque);
  const double torque = OwnEquation<double>(arm).holding_torque(position, 0.0);
  return std::clamp((2.0 * torque - limits.lower - limits.upper) / limits.length(), -1.0, 1.0);
}

}  // namespace dualarm
