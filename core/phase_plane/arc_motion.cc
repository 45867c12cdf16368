#include "core/phase_plane/arc_motion.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>

#include "core/phase_plane/extremal_rate.h"

namespace dualarm {
namespace {

/// Relative error at which the quadrature of a time stops subdividing: a digit above rounding.
constexpr double kQuadratureTolerance = 1e-13;
/// Subdivisions allowed for motions that nearly stall on the way.
constexpr unsigned kQuadratureDepth = 15;
/// By how much, relative to the arc, an integration may miss the arc's end before its steps are halved, and into how
/// many: motions that nearly stall magnify rounding, and no step is short enough for them.
constexpr double kEndTolerance = 1e-11;
constexpr int kMostParts = 4;
/// Ratio of an integrated arc's end speeds below which it is followed from the slower end: times near rest are unsure.
/// Otherwise from the end whose errors fade: forwards under friction.
constexpr double kSlowEnd = 1e-4;
/// Part of the speed over which the slope of an acceleration over the velocity is taken.
constexpr double kSlopeStep = 1e-6;
/// Part of a position below which an arc counts as this long: there the end tolerance is a few roundings of the
/// position.
constexpr double kShortestTravel = 1e-4;

}  // namespace

ArcMotion::ArcMotion(const System& system, const Arc& arc)
    : system_(&system), kind_(arc.kind), start_(arc.start), end_(arc.end) {
  const double direction = end_.position > start_.position ? 1.0 : -1.0;
  extreme_ = (kind_ == ArcKind::kAccelerate) == (direction > 0.0) ? Extreme::kHighest : Extreme::kLowest;
  const bool is_traced = kind_ != ArcKind::kCruise && system.velocity_matters(extreme_, direction);
  from_start_ = std::abs(start_.velocity) <= std::abs(end_.velocity);
  const auto [slow, fast] = std::minmax({std::abs(start_.velocity), std::abs(end_.velocity)});
  if (is_traced && slow > kSlowEnd * fast) from_start_ = errors_fade_forward();
  anchor_ = from_start_ ? start_ : end_;
  away_ = from_start_ ? direction : -direction;
  const double other_end = from_start_ ? end_.position : start_.position;
  if (anchor_.velocity * direction < 0.0) {
    backlash_ = std::abs(anchor_.velocity / acceleration(anchor_));
    anchor_.velocity = 0.0;
  }
  const double gain = away_ * acceleration(anchor_);
  const double travel = std::abs(end_.position - start_.position);
  const double behind = gain > 0.0 ? 0.5 * anchor_.velocity * anchor_.velocity / gain : 0.0;
  if (behind < travel) virtual_rest_ = behind;
  if (is_traced) {
    trace_.emplace(system, extreme_, anchor_, from_start_ ? 1.0 : -1.0, other_end,
                   std::numeric_limits<double>::infinity());
  }
  duration_ =
      kind_ == ArcKind::kCruise ? (end_.position - start_.position) / start_.velocity : time_from_anchor(other_end);
}

/// Whether the acceleration half way falls with the velocity, so that a motion that is too fast is slowed down.
bool ArcMotion::errors_fade_forward() const {
  JointState lower = {0.5 * (start_.position + end_.position), 0.5 * (start_.velocity + end_.velocity)};
  JointState upper = lower;
  const double step = kSlopeStep * std::abs(lower.velocity);
  lower.velocity -= step;
  upper.velocity += step;
  return acceleration(upper) <= acceleration(lower);
}

double ArcMotion::acceleration(JointState state) const {
  return kind_ == ArcKind::kCruise ? 0.0 : system_->extreme_acceleration(extreme_, state.position, state.velocity);
}

double ArcMotion::speed_squared(double change) const {
  return anchor_.velocity * anchor_.velocity + 2.0 * system_->specific_work(extreme_, anchor_.position, change);
}

double ArcMotion::change_at(double root) const { return away_ * std::max(0.0, root * root - virtual_rest_); }

/// d(root)/dt at position = virtual rest +- root^2: what is left of the speed when the singularity of a rest end, or of
/// an end close to it, is gone.
double ArcMotion::speed_near_anchor(double root) const {
  return std::sqrt(std::max(speed_squared(change_at(root)), 0.0)) / (2.0 * root);
}

double ArcMotion::quadrature(double root) const {
  const double first = std::sqrt(virtual_rest_);
  if (root <= first) return 0.0;
  // Over [-1, 1], always: on shorter intervals Boost 1.74 compares an error of the unit interval with a tolerance of
  // the short one and subdivides to the last level.
  const double half = 0.5 * (root - first);
  return half * boost::math::quadrature::gauss_kronrod<double, 21>::integrate(
                    [&](double at) { return 1.0 / speed_near_anchor(first + half * (1.0 + at)); }, -1.0, 1.0,
                    kQuadratureDepth, kQuadratureTolerance);
}

double ArcMotion::time_from_anchor(double position) const {
  if (trace_) return backlash_ + std::abs(trace_->at_position(position).time);
  return backlash_ + quadrature(std::sqrt(virtual_rest_ + std::max(0.0, away_ * (position - anchor_.position))));
}

double ArcMotion::time_at(double position) const {
  if (kind_ == ArcKind::kCruise) return (position - start_.position) / start_.velocity;
  const double time = time_from_anchor(position);
  return from_start_ ? time : duration_ - time;
}

JointState ArcMotion::at(double time) const {
  if (kind_ == ArcKind::kCruise) return {start_.position + start_.velocity * time, start_.velocity};
  return from_anchor(from_start_ ? time : duration_ - time);
}

JointState ArcMotion::from_anchor(double time) const {
  time = std::max(0.0, time - backlash_);
  if (trace_) return trace_->at_time(from_start_ ? time : -time);
  double low = std::sqrt(virtual_rest_);
  double high = std::sqrt(virtual_rest_ + std::abs(end_.position - start_.position));
  double root = std::lerp(low, high, std::clamp(time / (duration_ - backlash_), 0.0, 1.0));
  // Newton in the root coordinate, where a start from rest is a straight line; bisection keeps it inside.
  for (int i = 0; i < 60 && root > 0.0; ++i) {
    const double excess = quadrature(root) - time;
    (excess > 0.0 ? high : low) = root;
    const double step = -excess * speed_near_anchor(root);
    if (std::abs(step) <= 1e-15 * root || high - low <= 1e-15 * high) break;
    const double next = root + step;
    root = low < next && next < high ? next : 0.5 * (low + high);
  }
  const double change = change_at(root);
  const double sign = end_.position > start_.position ? 1.0 : -1.0;
  return {anchor_.position + change, sign * std::sqrt(std::max(0.0, speed_squared(change)))};
}

std::vector<JointState> ArcMotion::states(int count) const {
  const double step = duration_ / count;
  std::vector<JointState> states;
  if (kind_ == ArcKind::kCruise) {
    for (int i = 0; i <= count; ++i) states.push_back(at(step * i));
    states.back() = end_;
    return states;
  }
  // From the end whose errors fade, if they do at one only. The other end is known: an integration that misses it was
  // too coarse.
  const bool backward = trace_ && !from_start_;
  const JointState& other_end = backward ? start_ : end_;
  for (int parts = 1; parts <= kMostParts; parts *= 2) {
    states = integrated(backward ? end_ : start_, backward ? -step : step, count, parts);
    if (miss(states.back(), other_end) > kEndTolerance) continue;
    spread_miss(states, other_end, backward ? -duration_ : duration_);
    if (backward) std::reverse(states.begin(), states.end());
    return states;
  }
  if (backward) states = integrated(start_, step, count, kMostParts);
  return met_halfway(std::move(states), integrated(end_, -step, count, kMostParts));
}

/// States from one on, `count` steps of `step` s, each in `parts` steps of the integration.
std::vector<JointState> ArcMotion::integrated(const JointState& from, double step, int count, int parts) const {
  boost::numeric::odeint::runge_kutta_fehlberg78<PlaneState> stepper;
  const auto rate_of = extremal_rate(*system_, extreme_);
  std::vector<JointState> states = {from};
  states.reserve(count + 1);
  PlaneState state = {from.position, from.velocity};
  for (int i = 0; i < count; ++i) {
    for (int part = 0; part < parts; ++part) stepper.do_step(rate_of, state, 0.0, step / parts);
    states.push_back({state[0], state[1]});
  }
  return states;
}

/// By how much a state misses an end of the arc, relative to the arc; positions are no better than their own rounding.
double ArcMotion::miss(const JointState& state, const JointState& end) const {
  const double travel = std::abs(end_.position - start_.position) + kShortestTravel * std::abs(state.position);
  const double speed = std::max(std::abs(start_.velocity), std::abs(end_.velocity));
  return std::max(std::abs(state.position - end.position) / travel, std::abs(state.velocity - end.velocity) / speed);
}

/// What the integration misses the end by, taken from all states along the cubic that begins with none of it: its
/// acceleration is the least that the miss can show as. `span` (s) is from the first state to the last, negative
/// backwards in time.
void ArcMotion::spread_miss(std::vector<JointState>& states, const JointState& end, double span) {
  const double position_miss = end.position - states.back().position;
  const double velocity_miss = (end.velocity - states.back().velocity) * span;
  for (std::size_t i = 1; i < states.size(); ++i) {
    const double u = static_cast<double>(i) / static_cast<double>(states.size() - 1);
    states[i].position += u * u * ((3.0 - 2.0 * u) * position_miss + (u - 1.0) * velocity_miss);
    states[i].velocity += u * (6.0 * (1.0 - u) * position_miss + (3.0 * u - 2.0) * velocity_miss) / span;
  }
  states.back() = end;
}

/// A motion that nearly stalls magnifies every rounding on its way past the slow point, in either direction of time: so
/// each half is taken from its own end, up to where the two agree best.
std::vector<JointState> ArcMotion::met_halfway(std::vector<JointState> forward, std::vector<JointState> backward) {
  std::reverse(backward.begin(), backward.end());
  const auto apart = [&](std::size_t i) {
    return std::abs(forward[i].position - backward[i].position) + std::abs(forward[i].velocity - backward[i].velocity);
  };
  std::size_t meeting = 0;
  for (std::size_t i = 0; i < forward.size(); ++i) {
    if (apart(i) < apart(meeting)) meeting = i;
  }
  std::copy(backward.begin() + static_cast<std::ptrdiff_t>(meeting), backward.end(),
            forward.begin() + static_cast<std::ptrdiff_t>(meeting));
  return forward;
}

}  // namespace dualarm
