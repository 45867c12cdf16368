#include "core/phase_plane/profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/phase_plane/arc_motion.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

Profile::Profile(const System& system, double position) : system_(&system), start_(position), goal_(position) {}

Profile::Profile(const System& system, std::vector<Arc> arcs) : system_(&system), arcs_(std::move(arcs)) {
  if (arcs_.empty()) throw std::logic_error("a profile needs at least one arc");
  start_ = arcs_.front().start.position;
  goal_ = arcs_.back().end.position;
  for (Arc& arc : arcs_) {
    arc.start_time = duration_;
    duration_ += ArcMotion(*system_, arc).duration();
    arc.end_time = duration_;
  }
}

int Profile::direction() const { return goal_ > start_ ? 1 : goal_ < start_ ? -1 : 0; }

double Profile::acceleration_on(const Arc& arc, double position) const {
  return ArcMotion(*system_, arc).acceleration(position);
}

JointState Profile::at(double time) const {
  if (arcs_.empty() || time <= 0.0) return {start_, 0.0};
  if (time >= duration_) return {goal_, 0.0};
  const auto arc = std::find_if(arcs_.begin(), arcs_.end(), [&](const Arc& a) { return time < a.end_time; });
  return ArcMotion(*system_, *arc).at(time);
}

double Profile::time_at(double position) const {
  if (arcs_.empty()) return 0.0;
  const double sign = direction();
  if (sign * (position - start_) <= 0.0) return 0.0;
  if (sign * (goal_ - position) <= 0.0) return duration_;
  const auto arc =
      std::find_if(arcs_.begin(), arcs_.end(), [&](const Arc& a) { return sign * (a.end.position - position) >= 0.0; });
  return ArcMotion(*system_, *arc).time_at(position);
}

IntervalSet Profile::times_in(Interval positions) const {
  const bool holds_start = positions.contains(start_);
  const bool holds_goal = positions.contains(goal_);
  if (positions.empty() || positions.upper < std::min(start_, goal_) || positions.lower > std::max(start_, goal_)) {
    return {};
  }
  const bool rising = goal_ >= start_;
  const double first = holds_start ? -kInfinity : time_at(rising ? positions.lower : positions.upper);
  const double last = holds_goal ? kInfinity : time_at(rising ? positions.upper : positions.lower);
  return IntervalSet({{first, last}});
}

std::vector<JointState> Profile::states_along(const Arc& arc, int count) const {
  return ArcMotion(*system_, arc).states(count);
}

}  // namespace dualarm
