#include "core/phase_plane/arc_motion.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>

#include "core/phase_plane/extremal_rate.h"
#include "core/phase_plane/motion_series.h"

namespace dualarm {
namespace {

/// Subdivisions allowed for motions that nearly stall on the way.
constexpr unsigned kQuadratureDepth = 15;
/// By how much, relative to the arc, an integration may miss the arc's end before its steps are halved, and into how
/// many: motions that nearly stall magnify rounding, and no step is short enough for them.
constexpr double kEndTolerance = 1e-11;
constexpr int kMostParts = 4;
/// How far from its end an arc's last state may be left (rad at 1 rad, and rad/s, which is that over a slow arc's speed
/// times its acceleration), and the part of the span of accelerations as which the miss would have to show.
constexpr double kMostLeft = 1e-13;
constexpr double kMostVelocityLeft = 1e-10;
constexpr double kShownMiss = 5e-10;
/// By how much, relative to the arc, integrations from both of its ends may differ where they agree best. Where they
/// differ more, steps are so long that each is on a motion of its own.
constexpr double kMeetingTolerance = 1e-8;
/// Ratio of an integrated arc's end speeds below which it is followed from the slower end: times near rest are unsure.
/// Otherwise from the end whose errors fade: forwards under friction.
constexpr double kSlowEnd = 1e-4;
/// s: what the rounding of a position may cost a time taken at a fast end. Rounding, rad at 1 rad.
constexpr double kUnsureTime = 1e-12;
constexpr double kPositionRounding = 2e-16;
/// Part of the speed over which the slope of an acceleration over the velocity is taken.
constexpr double kSlopeStep = 1e-6;
/// Part of a position below which an arc counts as this long: there the end tolerance is a few roundings of the
/// position.
constexpr double kShortestTravel = 1e-4;
/// Part of a position below which an arc may be so short that its velocities tell its time better than its positions.
constexpr double kShort = 1e-6;
/// Relative miss of a trace's end beyond which it is lost.
constexpr double kLostTrace = 1e-8;
/// Part of a step that its multiples round off.
constexpr double kStepRounding = 1e-12;
/// Part of a duration by which a series for times may tell another one.
constexpr double kSameDuration = 1e-13;
/// Rounding of a velocity, relative.
constexpr double kVelocityRounding = 2e-16;

}  // namespace

ArcMotion::ArcMotion(const System& system, const Arc& arc, double tolerance)
    : system_(&system), tolerance_(tolerance), kind_(arc.kind), start_(arc.start), end_(arc.end) {
  const double direction = direction_of(arc);
  extreme_ = (kind_ == ArcKind::kAccelerate) == (direction > 0.0) ? Extreme::kHighest : Extreme::kLowest;
  const bool is_traced = kind_ != ArcKind::kCruise && system.velocity_matters(extreme_, direction);
  if (is_uniform()) {
    mean_acceleration_ = mean_over_time();
    duration_ = (end_.velocity - start_.velocity) / *mean_acceleration_;
    return;
  }
  from_start_ = std::abs(start_.velocity) <= std::abs(end_.velocity);
  const bool is_unsure = slow_end_is_unsure(direction);
  if (is_traced && !is_unsure) from_start_ = errors_fade_forward();
  take_anchor(direction, is_traced);
  // Creeping towards a slow end takes so long that nothing can be told backwards from there.
  if (is_traced && is_unsure && is_lost() && errors_fade_forward() != from_start_) {
    from_start_ = !from_start_;
    take_anchor(direction, is_traced);
  }
  const double other_end = from_start_ ? end_.position : start_.position;
  duration_ =
      kind_ == ArcKind::kCruise ? (end_.position - start_.position) / start_.velocity : time_from_anchor(other_end);
}

/// Measures times from the end that from_start_ says.
void ArcMotion::take_anchor(double direction, bool is_traced) {
  anchor_ = from_start_ ? start_ : end_;
  away_ = from_start_ ? direction : -direction;
  backlash_ = 0.0;
  if (anchor_.velocity * direction < 0.0) {
    backlash_ = std::abs(anchor_.velocity / acceleration(anchor_));
    anchor_.velocity = 0.0;
  }
  const double gain = away_ * acceleration(anchor_);
  const double travel = std::abs(end_.position - start_.position);
  const double behind = gain > 0.0 ? 0.5 * anchor_.velocity * anchor_.velocity / gain : 0.0;
  virtual_rest_ = behind < travel ? behind : 0.0;
  if (is_traced) {
    trace_.emplace(*system_, extreme_, anchor_, from_start_ ? 1.0 : -1.0, from_start_ ? end_.position : start_.position,
                   std::numeric_limits<double>::infinity());
  }
}

/// Whether the trace misses the velocity of the end that it leads to by more than the rounding of positions explains.
bool ArcMotion::is_lost() const {
  const double velocity = from_start_ ? end_.velocity : start_.velocity;
  const double rounding =
      kPositionRounding * (1.0 + std::abs(end_.position)) / std::abs(end_.position - start_.position);
  return std::abs(trace_->end().state.velocity - velocity) > (kLostTrace + 4.0 * rounding) * std::abs(velocity);
}

/// Whether positions round more off the arc than its acceleration changes: then its velocities tell its time.
bool ArcMotion::is_uniform() const {
  const double travel = std::abs(end_.position - start_.position);
  const double size = 1.0 + std::abs(end_.position);
  if (kind_ == ArcKind::kCruise || travel > kShort * size) return false;
  const double gain = end_.velocity - start_.velocity;
  const double first = acceleration(start_);
  const double last = acceleration(end_);
  if (!(first * gain > 0.0 && last * gain > 0.0)) return false;
  const double change = (last - first) / (last + first);
  const double speed = std::max(std::abs(start_.velocity), std::abs(end_.velocity));
  return change * change + kVelocityRounding * speed / std::abs(gain) < kPositionRounding * size / travel;
}

/// The acceleration's mean over the time of an arc on which it changes little: with the velocity evenly, with the
/// position more while the arc is slow.
double ArcMotion::mean_over_time() const {
  const double first = acceleration(start_);
  const double there = acceleration({end_.position, start_.velocity});
  const double last = acceleration(end_);
  const double sum = start_.velocity + end_.velocity;
  const double share = sum != 0.0 ? (2.0 * start_.velocity + end_.velocity) / (3.0 * sum) : 0.5;
  return first + share * (there - first) + 0.5 * (last - there);
}

/// Whether the time at which the arc passes its slower end could not be told from the other end.
bool ArcMotion::slow_end_is_unsure(double direction) const {
  const JointState& slower = from_start_ ? start_ : end_;
  const double slow = direction * slower.velocity;
  const double fast = direction * (from_start_ ? end_ : start_).velocity;
  return slow <= kSlowEnd * fast || kPositionRounding * (1.0 + std::abs(slower.position)) > kUnsureTime * slow;
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

/// dt/d(root) at position = virtual rest +- root^2: what is left of the time's rate when the singularity of a rest end,
/// or of an end close to it, is gone.
double ArcMotion::slowness_near_anchor(double root) const {
  return 2.0 * root / std::sqrt(std::max(speed_squared(change_at(root)), 0.0));
}

double ArcMotion::first_root() const { return std::sqrt(virtual_rest_); }

double ArcMotion::last_root() const { return std::sqrt(virtual_rest_ + std::abs(end_.position - start_.position)); }

void ArcMotion::expect_questions() {
  if (kind_ == ArcKind::kCruise || mean_acceleration_ || trace_ || clock_) return;
  const auto series =
      IntegralSeries::of([this](double root) { return slowness_near_anchor(root); }, first_root(), last_root());
  if (!series) return;
  const double end = backlash_ + series->up_to(last_root());
  if (std::abs(end - duration_) <= kSameDuration * duration_) clock_ = std::make_shared<IntegralSeries>(*series);
}

double ArcMotion::quadrature(double root) const {
  const double first = first_root();
  if (root <= first) return 0.0;
  if (clock_) return clock_->up_to(root);
  // Over [-1, 1], always: on shorter intervals Boost 1.74 compares an error of the unit interval with a tolerance of
  // the short one and subdivides to the last level.
  const double half = 0.5 * (root - first);
  const auto slowness = [&](double at) { return slowness_near_anchor(first + half * (1.0 + at)); };
  using boost::math::quadrature::gauss_kronrod;
  const bool is_lean = tolerance_ >= kLean;
  return half * (is_lean ? gauss_kronrod<double, 15>::integrate(slowness, -1.0, 1.0, kQuadratureDepth, tolerance_)
                         : gauss_kronrod<double, 21>::integrate(slowness, -1.0, 1.0, kQuadratureDepth, tolerance_));
}

double ArcMotion::time_from_anchor(double position) const {
  if (trace_) return backlash_ + std::abs(trace_->at_position(position).time);
  return backlash_ + quadrature(std::sqrt(virtual_rest_ + std::max(0.0, away_ * (position - anchor_.position))));
}

double ArcMotion::time_at(double position) const {
  if (kind_ == ArcKind::kCruise) return (position - start_.position) / start_.velocity;
  if (mean_acceleration_) {
    const double square = start_.velocity * start_.velocity + 2.0 * *mean_acceleration_ * (position - start_.position);
    const double velocity = std::copysign(std::sqrt(std::max(0.0, square)), start_.velocity + end_.velocity);
    return std::clamp((velocity - start_.velocity) / *mean_acceleration_, 0.0, duration_);
  }
  const double time = time_from_anchor(position);
  return from_start_ ? time : duration_ - time;
}

double ArcMotion::velocity_at(double position) const {
  if (kind_ == ArcKind::kCruise) return start_.velocity;
  if (mean_acceleration_) return start_.velocity + *mean_acceleration_ * time_at(position);
  if (trace_) return trace_->at_position(position).state.velocity;
  return (from_start_ ? away_ : -away_) * std::sqrt(std::max(0.0, speed_squared(position - anchor_.position)));
}

JointState ArcMotion::at(double time) const {
  if (kind_ == ArcKind::kCruise) return {start_.position + start_.velocity * time, start_.velocity};
  if (mean_acceleration_) {
    const double velocity = start_.velocity + *mean_acceleration_ * time;
    return {start_.position + 0.5 * (start_.velocity + velocity) * time, velocity};
  }
  return from_anchor(from_start_ ? time : duration_ - time);
}

JointState ArcMotion::from_anchor(double time) const {
  time = std::max(0.0, time - backlash_);
  if (trace_) return trace_->at_time(from_start_ ? time : -time);
  double low = first_root();
  double high = last_root();
  double root = std::lerp(low, high, std::clamp(time / (duration_ - backlash_), 0.0, 1.0));
  // Newton in the root coordinate, where a start from rest is a straight line; bisection keeps it inside.
  for (int i = 0; i < 60 && root > 0.0; ++i) {
    const double excess = quadrature(root) - time;
    (excess > 0.0 ? high : low) = root;
    const double step = -excess / slowness_near_anchor(root);
    if (std::abs(step) <= 1e-15 * root || high - low <= 1e-15 * high) break;
    const double next = root + step;
    root = low < next && next < high ? next : 0.5 * (low + high);
  }
  const double change = change_at(root);
  const double sign = from_start_ ? away_ : -away_;
  return {anchor_.position + change, sign * std::sqrt(std::max(0.0, speed_squared(change)))};
}

std::vector<JointState> ArcMotion::states(int count) const {
  const double step = duration_ / count;
  std::vector<JointState> states;
  if (kind_ == ArcKind::kCruise) {
    states.reserve(count + 1);
    for (int i = 0; i <= count; ++i) states.push_back(at(step * i));
    states.back() = end_;
    return states;
  }
  // From the end whose errors fade, if they do at one only. The other end is known: an integration that misses it was
  // too coarse.
  const bool backward = trace_ && !from_start_;
  const JointState& other_end = backward ? start_ : end_;
  for (int parts = 1; parts <= kMostParts; parts *= 2) {
    const JointState& from = backward ? end_ : start_;
    const double signed_step = backward ? -step : step;
    if (parts == 1) states = along_series(from, signed_step, count);
    if (parts > 1 || states.empty()) states = integrated(from, signed_step, count, parts);
    const bool is_left = may_leave_miss(states.back(), other_end);
    if (!is_left && !(miss(states.back(), other_end) <= kEndTolerance)) continue;
    if (!is_left) spread_miss(states, other_end, backward ? -duration_ : duration_);
    if (backward) std::reverse(states.begin(), states.end());
    return states;
  }
  if (backward) states = integrated(start_, step, count, kMostParts);
  if (auto met = met_halfway(std::move(states), integrated(end_, -step, count, kMostParts))) return std::move(*met);
  states = {start_};
  for (int i = 1; i < count; ++i) states.push_back(at(step * i));
  states.push_back(end_);
  return states;
}

/// States from one on, `count` steps of `step` s, many by one series; none where no series is known or reaches that
/// far.
std::vector<JointState> ArcMotion::along_series(const JointState& from, double step, int count) const {
  std::vector<JointState> states = {from};
  states.reserve(count + 1);
  double way_before = 0.0;
  for (int done = 0; done < count;) {
    const auto series = MotionSeries::about(*system_, extreme_, {from.position + way_before, states.back().velocity});
    if (!series) return {};
    const double reach = series->reach(std::abs(step) * (count - done));
    const int steps = std::min(count - done, static_cast<int>(reach / std::abs(step) * (1.0 + kStepRounding)));
    if (steps < 1) return {};
    PlaneState state = {};
    for (int i = 1; i <= steps; ++i) {
      state = series->at(step * i);
      states.push_back({from.position + (way_before + state[0]), state[1]});
    }
    way_before += state[0];
    done += steps;
  }
  return states;
}

/// States from one on, `count` steps of `step` s, each in `parts` steps of the integration.
std::vector<JointState> ArcMotion::integrated(const JointState& from, double step, int count, int parts) const {
  boost::numeric::odeint::runge_kutta_fehlberg78<PlaneState> stepper;
  // The way from the first state, not the position: short arcs would show the rounding of each step.
  const auto rate_of = extremal_rate(*system_, extreme_, from.position);
  std::vector<JointState> states = {from};
  states.reserve(count + 1);
  PlaneState state = {0.0, from.velocity};
  for (int i = 0; i < count; ++i) {
    for (int part = 0; part < parts; ++part) stepper.do_step(rate_of, state, 0.0, step / parts);
    states.push_back({from.position + state[0], state[1]});
  }
  return states;
}

/// By how much a state misses an end of the arc, relative to the arc; positions are no better than their own rounding.
double ArcMotion::miss(const JointState& state, const JointState& end) const {
  const double travel = std::abs(end_.position - start_.position) + kShortestTravel * std::abs(state.position);
  const double speed = std::max(std::abs(start_.velocity), std::abs(end_.velocity));
  // Not std::max, which overlooks what is no number.
  return std::hypot((state.position - end.position) / travel, (state.velocity - end.velocity) / speed);
}

/// Whether what an integration misses the end by is a few roundings that would show as acceleration however they are
/// spread along the arc: the end then is a last digit off.
bool ArcMotion::may_leave_miss(const JointState& state, const JointState& end) const {
  const double position_miss = std::abs(end.position - state.position);
  const double velocity_miss = std::abs(end.velocity - state.velocity);
  if (position_miss > kMostLeft * (1.0 + std::abs(end.position)) || velocity_miss > kMostVelocityLeft) return false;
  const double shown = (6.0 * position_miss / duration_ + 4.0 * velocity_miss) / duration_;
  return shown > kShownMiss * system_->acceleration(state.position, state.velocity).length();
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
/// each half is taken from its own end, up to where the two agree best. Nothing if they agree nowhere: the steps are
/// too long for either.
std::optional<std::vector<JointState>> ArcMotion::met_halfway(std::vector<JointState> forward,
                                                              std::vector<JointState> backward) const {
  std::reverse(backward.begin(), backward.end());
  std::size_t meeting = 0;
  double least = kMeetingTolerance;
  for (std::size_t i = 1; i < forward.size(); ++i) {
    const double apart = miss(forward[i], backward[i]);
    if (!(apart <= least)) continue;
    meeting = i;
    least = apart;
  }
  if (meeting == 0) return std::nullopt;
  std::copy(backward.begin() + static_cast<std::ptrdiff_t>(meeting), backward.end(),
            forward.begin() + static_cast<std::ptrdiff_t>(meeting));
  return forward;
}

}  // namespace dualarm
