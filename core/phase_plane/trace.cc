#include "core/phase_plane/trace.h"

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>

#include "core/phase_plane/extremal_rate.h"

namespace dualarm {
namespace {

/// Error that a step may make, relative to the length of the way and to the highest speed on it: near rounding, because
/// what is left of it shows in the accelerations of a fine playback.
constexpr double kStepTolerance = 1e-15;
/// Nodes after which an arc counts as one that creeps towards rest for ever.
constexpr std::size_t kMostNodes = 20000;
/// Part of the time of a free run over the way that the first step takes, and the least part of it that any step takes:
/// far less than the time of the strongest friction on the lightest arm, over which a step must not pass.
constexpr double kFirstStep = 0.1;
constexpr double kLeastStep = 1e-30;
/// Excess over the speed limit, relative to it, that is rounding: an arc that leaves the limit begins on it.
constexpr double kLimitRounding = 1e-13;
/// Part of its step at which the search for a point on it stops: the next correction would be its square, and its most
/// iterations.
constexpr double kLocation = 1e-12;
constexpr int kMostIterations = 60;
/// Rounding of a position, rad at 1 rad: so close to a node, a position is the node's.
constexpr double kPositionRounding = 4e-16;
/// Part of its step to which a turn of the speed is found: the speed is flat there.
constexpr double kTurnOfSpeed = 1e-6;

/// Part of the first step down to which a step is tried that leaves the limit downwards and might come back to it.
constexpr double kLeastDip = 1e-8;
/// Rounding of an acceleration, relative to the span of the admissible ones: shorter steps do not help against it.
constexpr double kAccelerationRounding = 4e-16;
/// Error of the speed that a step may make, relative to its own speed: where an arc begins far slower than it becomes,
/// more would turn it round.
constexpr double kOwnStepTolerance = 1e-4;

/// Part of the highest speed below which an arc that slows down counts as one that creeps towards rest for ever: what
/// comes to rest in finite time passes such speeds within a step, and stands a rounding from its end.
constexpr double kCreep = 1e-9;

/// Part of the first step below which no step is doubted: the time of the strongest drives is not shorter.
constexpr double kLeastDoubt = 1e-9;

/// By how much, relative to the way and to the highest speed on it, a step and its two halves may differ: some
/// roundings.
constexpr double kHalvesTolerance = 2e-14;

/// By what factor the error of a step is above what it may be.
double miss_of(const PlaneState& before, const PlaneState& after, const PlaneState& error, double way, double allowed) {
  if (!std::isfinite(after[0]) || !std::isfinite(after[1])) return std::numeric_limits<double>::infinity();
  const double own = std::max(std::abs(before[1]), std::abs(after[1]));
  return std::max({std::abs(error[0]) / way / kStepTolerance, std::abs(error[1]) / allowed,
                   std::abs(error[1]) / own / kOwnStepTolerance});
}

}  // namespace

Trace::Trace(const System& system, Extreme extreme, JointState from, double time_sign, double until, double speed_limit)
    : system_(&system), extreme_(extreme), until_(until), speed_limit_(speed_limit), nodes_{{0.0, from, false}} {
  const double way = std::abs(until - from.position);
  if (way == 0.0) return;
  position_bends_ = system.position_bends({std::min(from.position, until), std::max(from.position, until)});
  velocity_bends_ = system.velocity_bends();
  const double speed = std::max(std::abs(from.velocity), std::sqrt(2.0 * std::abs(acceleration(from)) * way));
  if (speed == 0.0) {
    stop_ = Stop::kRest;
    return;
  }
  const double least = kLeastStep * way / speed;
  const double first = kFirstStep * way / speed;
  const double rounding = kAccelerationRounding * system.acceleration(from.position, from.velocity).length();
  double step = first;
  boost::numeric::odeint::runge_kutta_fehlberg78<PlaneState> stepper;
  while (nodes_.size() < kMostNodes) {
    const Node node = nodes_.back();
    const PlaneState before = {node.state.position, node.state.velocity};
    PlaneState after = before;
    PlaneState error = {0.0, 0.0};
    stepper.do_step(extremal_rate(system, extreme), before, 0.0, after, time_sign * step, error);
    const double miss =
        miss_of(before, after, error, way, kStepTolerance * std::max(speed, std::abs(after[1])) + rounding * step);
    const double growth = std::clamp(0.9 * std::pow(std::max(miss, 1e-8), -0.125), 0.2, 4.0);
    if (miss > 1.0 && step > least) {
      step = std::max(least, growth * step);
      continue;
    }
    const Node whole = {node.time + time_sign * step, {after[0], after[1]}, false};
    const Node next = up_to_turn_of_speed(whole);
    // An arc on the limit may leave it upwards by less than shows, and come back; but not for ever.
    const bool may_dip = nodes_.size() == 1 || time_sign * node.state.velocity * acceleration(node.state) <= 0.0;
    if (may_dip && std::abs(node.state.velocity) >= speed_limit && is_over_limit(next) && step > kLeastDip * first) {
      step *= 0.2;
      continue;
    }
    const double slower = std::abs(next.state.velocity);
    const bool creeps = slower < kCreep * speed && slower < std::abs(node.state.velocity);
    const bool goes_on = accept(next);
    // Next to a bend, and where a step is long for the drive, its stages may agree with each other and not with the
    // arc.
    const bool is_doubtful = nodes_.size() == 2 || node.at_bend || looks_over_bend(node, whole);
    if (is_doubtful && step > kLeastDoubt * first && !halves_agree(way, speed)) {
      step = 0.5 * std::min(step, std::max(std::abs(nodes_.back().time - node.time), kLeastDoubt * first));
      nodes_.pop_back();
      stop_ = Stop::kArrived;
      continue;
    }
    if (!goes_on) return;
    if (creeps) break;
    step = std::max(least, growth * step);
  }
  stop_ = Stop::kRest;
  end_where_slowest();
}

/// An arc that creeps for ever ends where it is slowest, not where patience ended: most of its nodes are about there.
void Trace::end_where_slowest() {
  const auto half = nodes_.begin() + static_cast<std::ptrdiff_t>(nodes_.size() / 2);
  const auto slowest = std::min_element(half, nodes_.end(), [](const Node& a, const Node& b) {
    return std::abs(a.state.velocity) < std::abs(b.state.velocity);
  });
  nodes_.erase(slowest + 1, nodes_.end());
}

/// The same step, cut where the acceleration changes its sign: then the speed is monotone on it, and its ends tell
/// whether it meets the limit or vanishes.
Trace::Node Trace::up_to_turn_of_speed(const Node& next) const {
  const Node& from = nodes_.back();
  const double before = acceleration(from.state);
  if (!(before * acceleration(next.state) < 0.0)) return next;
  double low = 0.0;
  double high = next.time - from.time;
  for (int i = 0; i < kMostIterations && std::abs(high - low) > kTurnOfSpeed * std::abs(next.time - from.time); ++i) {
    const double middle = 0.5 * (low + high);
    (before * acceleration(advanced(from.state, middle)) > 0.0 ? low : high) = middle;
  }
  return {from.time + high, advanced(from.state, high), false};
}

/// Whether two halves of the last step lead where the whole one led.
bool Trace::halves_agree(double way, double speed) const {
  const Node& from = nodes_[nodes_.size() - 2];
  const Node& to = nodes_.back();
  const double half = 0.5 * (to.time - from.time);
  const JointState there = advanced(advanced(from.state, half), half);
  const double size = std::max(way, kPositionRounding / kHalvesTolerance * (1.0 + std::abs(to.state.position)));
  return std::abs(there.position - to.state.position) <= kHalvesTolerance * size &&
         std::abs(there.velocity - to.state.velocity) <= kHalvesTolerance * std::max(speed, std::abs(there.velocity));
}

bool Trace::looks_over_bend(const Node& from, const Node& to) const {
  const auto between = [](const std::vector<double>& bends, double one, double other) {
    return std::any_of(bends.begin(), bends.end(), [&](double bend) { return (bend - one) * (bend - other) < 0.0; });
  };
  return between(position_bends_, from.state.position, to.state.position) ||
         between(velocity_bends_, from.state.velocity, to.state.velocity);
}

/// Appends the node that a step leads to, or the first point of the step at which something happens. False at the end.
bool Trace::accept(Node next) {
  const Node from = nodes_.back();
  bool goes_on = true;
  bool at_bend = false;
  const auto cut = [&](double target, double JointState::*what) {
    next = located(from, next.time - from.time, target, what);
    next.state.*what = target;
  };
  const double direction = until_ > nodes_.front().state.position ? 1.0 : -1.0;
  const auto crossed = [&](double target, double JointState::*what) {
    const double before = from.state.*what - target;
    const double after = next.state.*what - target;
    return (before < 0.0 && after >= 0.0) || (before > 0.0 && after <= 0.0);
  };
  const double side = std::copysign(1.0, from.state.velocity != 0.0 ? from.state.velocity : next.state.velocity);
  if (from.state.velocity != 0.0 && side * next.state.velocity <= 0.0) {
    cut(0.0, &JointState::velocity);
    stop_ = Stop::kRest;
    goes_on = false;
  }
  if (direction * (next.state.position - until_) >= 0.0) {
    cut(until_, &JointState::position);
    stop_ = Stop::kArrived;
    goes_on = false;
  }
  if (is_over_limit(next)) {
    if (std::abs(from.state.velocity) < speed_limit_) {
      cut(side * speed_limit_, &JointState::velocity);
    } else {
      next = {from.time, {from.state.position, side * speed_limit_}, false};
    }
    stop_ = Stop::kLimit;
    goes_on = false;
  }
  const auto meet_bend = [&](double bend, double JointState::*what) {
    if (!crossed(bend, what) || next.state.*what == bend) return;
    cut(bend, what);
    at_bend = true;
    goes_on = true;
  };
  for (const double bend : position_bends_) meet_bend(bend, &JointState::position);
  for (const double bend : velocity_bends_) meet_bend(bend, &JointState::velocity);
  next.at_bend = at_bend;
  // An arc is often asked for up to a bend: it has arrived, whichever of the two its last digit meets first.
  if (direction * (next.state.position - until_) >= -kPositionRounding * (1.0 + std::abs(until_))) {
    next.state.position = until_;
    stop_ = Stop::kArrived;
    goes_on = false;
  }
  nodes_.push_back(next);
  return goes_on;
}

bool Trace::is_over_limit(const Node& node) const {
  return std::abs(node.state.velocity) > (1.0 + kLimitRounding) * speed_limit_;
}

double Trace::acceleration(const JointState& state) const {
  return system_->extreme_acceleration(extreme_, state.position, state.velocity);
}

JointState Trace::advanced(const JointState& state, double step) const {
  boost::numeric::odeint::runge_kutta_fehlberg78<PlaneState> stepper;
  PlaneState moved = {state.position, state.velocity};
  stepper.do_step(extremal_rate(*system_, extreme_), moved, 0.0, step);
  return {moved[0], moved[1]};
}

/// The point within a step from a node at which the position or the velocity is `target`: Newton, kept inside by
/// bisection.
Trace::Node Trace::located(const Node& node, double step, double target, double JointState::*what) const {
  const double begin = node.state.*what - target;
  if (begin == 0.0) return node;
  double low = 0.0;
  double high = step;
  const double end = advanced(node.state, step).*what - target;
  double at = step * std::clamp(begin / (begin - end), 0.0, 1.0);
  JointState state = node.state;
  for (int i = 0; i < kMostIterations; ++i) {
    state = advanced(node.state, at);
    const double excess = state.*what - target;
    (excess * begin > 0.0 ? low : high) = at;
    const double slope = what == &JointState::position ? state.velocity : acceleration(state);
    const double next = at - excess / slope;
    if (excess == 0.0 || std::abs(next - at) <= kLocation * std::abs(step)) break;
    const bool is_inside = (next - low) * (next - high) < 0.0;
    at = is_inside ? next : 0.5 * (low + high);
  }
  return {node.time + at, state, false};
}

Trace::Node Trace::at_position(double position) const {
  const double sign = until_ > nodes_.front().state.position ? 1.0 : -1.0;
  const auto after = std::partition_point(nodes_.begin() + 1, nodes_.end(), [&](const Node& node) {
    return sign * (node.state.position - position) < 0.0;
  });
  if (nodes_.size() == 1 || after == nodes_.end()) return nodes_.back();
  const Node& before = *(after - 1);
  const double rounding = kPositionRounding * (1.0 + std::abs(position));
  if (sign * (before.state.position - position) >= -rounding) return before;
  if (sign * (after->state.position - position) <= rounding) return *after;
  return located(before, after->time - before.time, position, &JointState::position);
}

JointState Trace::at_time(double time) const {
  const double sign = nodes_.back().time >= 0.0 ? 1.0 : -1.0;
  const auto after = std::partition_point(nodes_.begin(), nodes_.end(),
                                          [&](const Node& node) { return sign * (node.time - time) < 0.0; });
  if (after == nodes_.end()) return nodes_.back().state;
  if (after == nodes_.begin() || after->time == time) return after->state;
  return advanced((after - 1)->state, time - (after - 1)->time);
}

}  // namespace dualarm
