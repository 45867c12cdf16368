// The states of an arc at evenly spaced times: the rows of knots.
#include <Eigen/Core>
#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <span>

#include "core/phase_plane/arc_motion.h"
#include "core/phase_plane/extremal_rate.h"
#include "core/phase_plane/motion_series.h"

namespace dualarm {
namespace {

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
/// Part of a position below which an arc counts as this long: there the end tolerance is a few roundings of the
/// position.
constexpr double kShortestTravel = 1e-4;
/// Part of a step that its multiples round off.
constexpr double kStepRounding = 1e-12;

}  // namespace

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
  std::vector<JointState> states(static_cast<std::size_t>(count) + 1);
  states.front() = from;
  double way_before = 0.0;
  for (int done = 0; done < count;) {
    const auto series = MotionSeries::about(*system_, extreme_, {from.position + way_before, states[done].velocity});
    if (!series) return {};
    const double reach = series->reach(std::abs(step) * (count - done));
    const int steps = std::min(count - done, static_cast<int>(reach / std::abs(step) * (1.0 + kStepRounding)));
    if (steps < 1) return {};
    const std::span<JointState> next(&states[done + 1], static_cast<std::size_t>(steps));
    series->follow(step, next);
    const double way = next.back().position;
    for (JointState& state : next) state.position = from.position + (way_before + state.position);
    way_before += way;
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
  const double square = 3.0 * position_miss - velocity_miss;  // of u, which goes from 0 to 1
  const double cube = velocity_miss - 2.0 * position_miss;
  const auto last = static_cast<int>(states.size() - 1);
  const double part = 1.0 / last;
  // By powers of u, of the position and of the velocity together.
  const Eigen::Array2d first = {0.0, 2.0 * square / span};
  const Eigen::Array2d second = {square, 3.0 * cube / span};
  const Eigen::Array2d third = {cube, 0.0};
  for (int i = 1; i < last; ++i) {
    const double u = i * part;
    JointState& state = states[static_cast<std::size_t>(i)];
    const Eigen::Array2d moved =
        Eigen::Array2d(state.position, state.velocity) + u * (first + u * (second + u * third));
    state = {moved[0], moved[1]};
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
