#include "core/phase_plane/arc_motion.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>

#include "core/phase_plane/sine_slowness.h"

namespace dualarm {
namespace {

/// Subdivisions allowed for motions that nearly stall on the way.
constexpr unsigned kQuadratureDepth = 15;
/// Ratio of an integrated arc's end speeds below which it is followed from the slower end: times near rest are unsure.
/// Otherwise from the end whose errors fade: forwards under friction.
constexpr double kSlowEnd = 1e-4;
/// s: what the rounding of a position may cost a time taken at a fast end. Rounding, rad at 1 rad.
constexpr double kUnsureTime = 1e-12;
constexpr double kPositionRounding = 2e-16;
/// Part of the speed over which the slope of an acceleration over the velocity is taken.
constexpr double kSlopeStep = 1e-6;
/// Part of a position below which an arc may be so short that its velocities tell its time better than its positions.
constexpr double kShort = 1e-6;
/// Relative miss of a trace's end beyond which it is lost.
constexpr double kLostTrace = 1e-8;
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
  if (!is_traced && kind_ != ArcKind::kCruise) work_ = system_->work_from(extreme_, anchor_.position);
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
  const double work = work_ ? work_->over(change) : system_->specific_work(extreme_, anchor_.position, change);
  return anchor_.velocity * anchor_.velocity + 2.0 * work;
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
  if (work_) {
    const SineSlowness slowness(*work_, anchor_.velocity, away_, virtual_rest_);
    if (const auto time = slowness.time(first, root)) return *time;
  }
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

}  // namespace dualarm
