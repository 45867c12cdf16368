#include "core/systems/playback.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace dualarm {
namespace {

/// Part of the acceleration scale by which the quintic between two knots may depart from the arc.
constexpr double kInterpolationError = 1e-9;
/// Rounding of positions (rad) as it shows in the quintic's acceleration, times the square of the spacing.
constexpr double kPositionRounding = 1e-14;
/// Number of intervals of an arc up to which it may double.
constexpr int kMostIntervals = 16384;

/// State and acceleration of the quintic in the middle between two knots.
struct Middle {
  double position;
  double velocity;
  double acceleration;
};

Middle middle_of(const Knot& from, const Knot& to) {
  const double h = to.time - from.time;
  const double velocity_change = to.velocity - from.velocity;
  return {0.5 * (from.position + to.position) - 5.0 * h / 32.0 * velocity_change +
              h * h / 64.0 * (from.acceleration + to.acceleration),
          1.875 * (to.position - from.position) / h - 0.4375 * (from.velocity + to.velocity) +
              h / 32.0 * (to.acceleration - from.acceleration),
          1.5 * velocity_change / h - 0.25 * (from.acceleration + to.acceleration)};
}

class Player {
 public:
  Player(const Arm& arm, const SingleJointArm& system, double duration, double knot_period)
      : system_(system), duration_(duration), knot_period_(knot_period) {
    played_.arm = arm.name;
  }

  void hold(double position, double until) {
    if (until <= now_) return;
    played_.arcs.push_back({ArcKind::kHold, now_, until, {position, 0.0}, {position, 0.0}});
    add_rest(position, now_);
    add_rest(position, until);
    now_ = until;
  }

  /// Times are sums that others have rounded in another order: a motion begins no earlier than the one before ended,
  /// and ends no later than the plan.
  void move(const TimedProfile& motion) {
    for (const Arc& arc : motion.profile.arcs()) {
      Arc placed = arc;
      placed.start_time = now_;
      placed.end_time = std::clamp(motion.start_time + arc.end_time, now_, duration_);
      const std::vector<Knot> knots = knots_along(motion.profile, arc, placed);
      played_.arcs.push_back(placed);
      played_.knots.insert(played_.knots.end(), knots.begin(), knots.end());
      now_ = placed.end_time;
    }
  }

  void add_rest(double position, double time) {
    played_.knots.push_back({time, position, 0.0, 0.0, system_.torque({position, 0.0}, 0.0)});
  }

  ArmTrajectory finish(const std::vector<TimedProfile>& motions) {
    const auto moves = [](const TimedProfile& motion) { return !motion.profile.stands_still(); };
    const auto first = std::find_if(motions.begin(), motions.end(), moves);
    const auto last = std::find_if(motions.rbegin(), motions.rend(), moves);
    if (first != motions.end()) {
      played_.start_time = first->start_time;
      played_.duration = last->start_time + last->profile.duration() - first->start_time;
    }
    if (played_.knots.size() == 1) played_.knots.push_back(played_.knots.front());  // a plan of no duration
    return std::move(played_);
  }

 private:
  std::vector<Knot> knots_along(const Profile& profile, const Arc& arc, const Arc& placed) const {
    int count = std::max(1, static_cast<int>(std::ceil((arc.end_time - arc.start_time) / knot_period_)));
    std::vector<Knot> knots = knots_along(profile, arc, placed, count);
    while (2 * count <= kMostIntervals && !faithful(profile, arc, knots)) {
      count *= 2;
      knots = knots_along(profile, arc, placed, count);
    }
    return knots;
  }

  std::vector<Knot> knots_along(const Profile& profile, const Arc& arc, const Arc& placed, int count) const {
    const double step = (placed.end_time - placed.start_time) / count;
    std::vector<Knot> knots;
    knots.reserve(count + 1);
    for (const JointState& state : profile.states_along(arc, count)) {
      const double acceleration = profile.acceleration_on(arc, state);
      const double time = placed.start_time + step * static_cast<double>(knots.size());
      knots.push_back({time, state.position, state.velocity, acceleration, system_.torque(state, acceleration)});
    }
    knots.back().time = placed.end_time;
    return knots;
  }

  bool faithful(const Profile& profile, const Arc& arc, const std::vector<Knot>& knots) const {
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      const Middle middle = middle_of(knots[i], knots[i + 1]);
      const double h = knots[i + 1].time - knots[i].time;
      const double scale = system_.acceleration(middle.position, middle.velocity).length();
      const double rounding = kPositionRounding * (1.0 + std::abs(middle.position)) / (h * h);
      const double error =
          std::abs(middle.acceleration - profile.acceleration_on(arc, {middle.position, middle.velocity}));
      if (error > kInterpolationError * scale + rounding) return false;
    }
    return true;
  }

  const SingleJointArm& system_;
  double duration_;
  double knot_period_;
  double now_ = 0.0;
  ArmTrajectory played_;
};

}  // namespace

ArmTrajectory play(const Arm& arm, const SingleJointArm& system, const std::vector<TimedProfile>& motions,
                   double duration, double knot_period) {
  if (motions.empty()) throw std::logic_error("an arm without motions has no position to hold");
  Player player(arm, system, duration, knot_period);
  for (const TimedProfile& motion : motions) {
    player.hold(motion.profile.start(), motion.start_time);
    player.move(motion);
  }
  const double goal = motions.back().profile.goal();
  player.hold(goal, duration);
  player.add_rest(goal, duration);
  return player.finish(motions);
}

}  // namespace dualarm
