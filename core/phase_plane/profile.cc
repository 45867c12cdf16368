#include "core/phase_plane/profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

Profile::Profile(const System& system, JointState state) : system_(&system), start_(state), goal_(state) {}

Profile::Profile(const System& system, std::vector<Arc> arcs) : system_(&system), arcs_(std::move(arcs)) {
  if (arcs_.empty()) throw std::logic_error("a profile needs at least one arc");
  motions_.reserve(arcs_.size());
  start_ = arcs_.front().start;
  goal_ = arcs_.back().end;
  for (std::size_t i = 0; i < arcs_.size(); ++i) {
    Arc& arc = arcs_[i];
    arc.start_time = duration_;
    motions_.emplace_back(*system_, arc);
    duration_ += motions_.back().duration();
    arc.end_time = duration_;
    if (i == 0 || direction_of(arc) != direction_of(arcs_[i - 1]))
      legs_.push_back({i, i, arc.start_time, 0.0, arc.start.position, 0.0});
    Leg& leg = legs_.back();
    leg.last_arc = i;
    leg.end_time = arc.end_time;
    leg.goal = arc.end.position;
  }
}

Profile Profile::asked_often() const {
  Profile prepared = *this;
  for (ArcMotion& motion : prepared.motions_) motion.expect_questions();
  return prepared;
}

Interval Profile::extent() const {
  Interval extent = {std::min(start(), goal()), std::max(start(), goal())};
  for (const Leg& leg : legs_) extent = {std::min(extent.lower, leg.goal), std::max(extent.upper, leg.goal)};
  return extent;
}

const ArcMotion& Profile::motion_of(const Arc& arc) const { return motions_.at(&arc - arcs_.data()); }

double Profile::acceleration_on(const Arc& arc, JointState state) const { return motion_of(arc).acceleration(state); }

JointState Profile::at(double time) const {
  if (arcs_.empty() || time <= 0.0) return start_;
  if (time >= duration_) return goal_;
  const auto arc = std::find_if(arcs_.begin(), arcs_.end(), [&](const Arc& a) { return time < a.end_time; });
  return motion_of(*arc).at(time - arc->start_time);
}

double Profile::time_at(const Leg& leg, double position) const {
  const double sign = leg.goal > leg.start ? 1.0 : -1.0;
  if (sign * (position - leg.start) <= 0.0) return leg.start_time;
  if (sign * (leg.goal - position) <= 0.0) return leg.end_time;
  const std::size_t arc = arc_at(leg, position);
  return arcs_[arc].start_time + motions_[arc].time_at(position);
}

double Profile::velocity_at(const Leg& leg, double position) const {
  const double sign = leg.goal > leg.start ? 1.0 : -1.0;
  if (sign * (position - leg.start) <= 0.0) return arcs_[leg.first_arc].start.velocity;
  if (sign * (leg.goal - position) <= 0.0) return arcs_[leg.last_arc].end.velocity;
  return motions_[arc_at(leg, position)].velocity_at(position);
}

/// The arc of a leg that passes a position between its ends.
std::size_t Profile::arc_at(const Leg& leg, double position) const {
  const double sign = leg.goal > leg.start ? 1.0 : -1.0;
  std::size_t arc = leg.first_arc;
  while (arc < leg.last_arc && sign * (arcs_[arc].end.position - position) < 0.0) ++arc;
  return arc;
}

TimedState Profile::passed_near(double time) const {
  if (arcs_.empty() || time <= 0.0) return {0.0, start_};
  if (time >= duration_) return {duration_, goal_};
  const auto arc = std::find_if(arcs_.begin(), arcs_.end(), [&](const Arc& a) { return time < a.end_time; });
  const double span = arc->end_time - arc->start_time;
  const double share = (time - arc->start_time) / span;
  const double rest = 1.0 - share;
  // The cubic with both ends' positions and velocities.
  const double position =
      rest * rest * ((1.0 + 2.0 * share) * arc->start.position + share * span * arc->start.velocity) +
      share * share * ((1.0 + 2.0 * rest) * arc->end.position - rest * span * arc->end.velocity);
  const auto [lower, upper] = std::minmax(arc->start.position, arc->end.position);
  const double passed = std::clamp(position, lower, upper);
  const ArcMotion& motion = motion_of(*arc);
  return {arc->start_time + motion.time_at(passed), {passed, motion.velocity_at(passed)}};
}

double Profile::largest_acceleration() const {
  if (arcs_.empty()) return 0.0;
  const Interval bounds = system_->acceleration_bounds();
  return std::max(std::abs(bounds.lower), std::abs(bounds.upper));
}

IntervalSet Profile::times_in(Interval positions) const {
  IntervalList times;
  add_times_in(positions, times);
  return IntervalSet({times.begin(), times.end()});
}

void Profile::add_times_in(Interval positions, IntervalList& times) const {
  if (positions.empty()) return;
  if (positions.contains(start())) times.push_back({-kInfinity, 0.0});
  if (positions.contains(goal())) times.push_back({duration_, kInfinity});
  for (const Leg& leg : legs_) {
    const bool rising = leg.goal > leg.start;
    if (positions.upper < std::min(leg.start, leg.goal) || positions.lower > std::max(leg.start, leg.goal)) continue;
    times.push_back({time_at(leg, rising ? positions.lower : positions.upper),
                     time_at(leg, rising ? positions.upper : positions.lower)});
  }
}

std::vector<JointState> Profile::states_along(const Arc& arc, int count) const { return motion_of(arc).states(count); }

}  // namespace dualarm
