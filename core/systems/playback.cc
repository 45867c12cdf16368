#include "core/systems/playback.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>

namespace dualarm {
namespace {

/// Part of the acceleration scale by which the quintic between two knots may depart from the arc.
constexpr double kInterpolationError = 5e-10;
/// Rounding of positions (rad at 1 rad) as it shows in the quintic's acceleration, times the square of the spacing:
/// less than verification forgives.
constexpr double kPositionRounding = 6e-16;
/// s: shorter arcs are no motion but a jump of their knots.
constexpr double kShortestArc = 2e-11;
/// s: arms that arrive this much before the plan's end arrive with it. Two durations that are meant to be one differ by
/// less, and no acceleration shows it.
constexpr double kShortestHold = 1e-10;
/// Part of a plan's duration by which times that others have rounded in another order may differ.
constexpr double kTimeRounding = 1e-12;
/// Each such middle is looked at on a smooth arc.
constexpr std::size_t kSmoothStride = 8;
/// How much more the speeds and accelerations between knots may make of the sixth derivative than those at knots.
constexpr double kSmoothReserve = 2.0;
/// Number of intervals of an arc up to which it may double.
constexpr int kMostIntervals = 16384;
/// Ratio of unfaithfulness after a doubling and before that counts as a gain: true arcs gain a factor of sixteen.
constexpr double kGain = 0.5;
/// Arcs of most motions are no more: each may have a knot more than its time asks.
constexpr std::size_t kFewArcs = 16;
/// Doublings in a row that may bring nothing: the first ones of a very coarse period need not.
constexpr int kVainDoublings = 4;

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
    played_.knots.reserve(static_cast<std::size_t>(duration / knot_period) + kFewArcs);
  }

  /// Stays in a state until a time, which takes rest or no time.
  void hold(JointState state, double until) {
    if (state.velocity != 0.0) {
      if (std::abs(until - now_) > kTimeRounding * duration_ + kShortestArc) {
        throw std::logic_error("an arm that moves cannot wait for its next motion or the end of the plan");
      }
      return;
    }
    if (until <= now_) return;
    played_.arcs.push_back({ArcKind::kHold, now_, until, state, state});
    add_knot(state, now_);
    add_knot(state, until);
    now_ = until;
  }

  /// A motion begins no earlier than the one before ended, and ends no later than the plan.
  void move(const TimedProfile& motion) {
    for (const Arc& arc : motion.profile.arcs()) {
      Arc placed = arc;
      placed.start_time = now_;
      placed.end_time = std::clamp(motion.start_time + arc.end_time, now_, duration_);
      if (placed.end_time - now_ < kShortestArc) placed.end_time = now_;
      if (duration_ - placed.end_time < kShortestHold) placed.end_time = duration_;
      add_knots_along(motion.profile, arc, placed);
      played_.arcs.push_back(placed);
      now_ = placed.end_time;
    }
  }

  /// In the state in which the plan ends: at rest, or under the last motion's torque.
  void end_in(JointState state) {
    if (state.velocity == 0.0 || played_.knots.empty()) return add_knot(state, duration_);
    played_.knots.back().time = played_.arcs.back().end_time = duration_;
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
  /// Without acceleration, as far as the state allows it.
  void add_knot(JointState state, double time) {
    const Interval admissible = system_.acceleration(state.position, state.velocity);
    const double acceleration = state.velocity == 0.0 ? 0.0 : std::clamp(0.0, admissible.lower, admissible.upper);
    played_.knots.push_back({time, state.position, state.velocity, acceleration, system_.torque(state, acceleration)});
  }

  /// Of a position and of a time, as a position.
  static double rounding_of(double time, const JointState& state) {
    return kPositionRounding * (std::abs(state.position) + std::abs(state.velocity) * time);
  }

  /// One interval could be symmetric, and half way between its knots right by chance; but where two would be so short
  /// that the rounding of positions shows, one is all that can be had.
  int fewest(const Arc& arc) const {
    const double h = 0.5 * (arc.end_time - arc.start_time);
    const double scale = system_.acceleration(arc.start.position, arc.start.velocity).length();
    const double rounding = rounding_of(arc.start_time, arc.start) / (h * h);
    return rounding > kInterpolationError * scale ? 1 : 2;
  }

  void add_knots_along(const Profile& profile, const Arc& arc, const Arc& placed) {
    const std::size_t first = played_.knots.size();
    int count = std::max(fewest(arc), static_cast<int>(std::ceil((arc.end_time - arc.start_time) / knot_period_)));
    double least = place_knots(first, profile, arc, placed, count);
    // Where the states' own rounding is what is left, closer knots only magnify it.
    int vain = 0;
    int kept = count;
    while (least > 1.0 && vain < kVainDoublings && 2 * count <= kMostIntervals) {
      count *= 2;
      const double now = place_knots(first, profile, arc, placed, count);
      vain = now < kGain * least || !std::isfinite(least) ? 0 : vain + 1;
      if (vain > 0) continue;
      least = now;
      kept = count;
    }
    if (kept != count) place_knots(first, profile, arc, placed, kept);
  }

  /// Knots from the `first` one on, all that come after the knots before this arc, and how unfaithful they are.
  double place_knots(std::size_t first, const Profile& profile, const Arc& arc, const Arc& placed, int count) {
    const double step = (placed.end_time - placed.start_time) / count;
    played_.knots.resize(first);
    double steps = 0.0;
    for (const JointState& state : profile.states_along(arc, count)) {
      played_.knots.push_back({placed.start_time + step * steps++, state.position, state.velocity, 0.0, 0.0});
    }
    played_.knots.back().time = placed.end_time;
    const std::span<Knot> knots = std::span(played_.knots).subspan(first);
    system_.drive(profile.extreme_on(arc), knots);
    return unfaithfulness(profile, arc, knots);
  }

  /// The largest part of what it may by which the quintic departs from the arc's acceleration half way between knots.
  /// Where the arc is smooth enough for all knots, only some tell whether they are on one arc.
  double unfaithfulness(const Profile& profile, const Arc& arc, std::span<const Knot> knots) const {
    const std::optional<Extreme> extreme = profile.extreme_on(arc);
    const std::size_t stride = is_smooth(arc, knots) ? kSmoothStride : 1;
    double largest = 0.0;
    for (std::size_t i = 0; i + 1 < knots.size(); i += stride) {
      const Middle middle = middle_of(knots[i], knots[i + 1]);
      const double h = knots[i + 1].time - knots[i].time;
      const SingleJointArm::Drive drive = system_.drive(extreme, {middle.position, middle.velocity});
      const double rounding = rounding_of(knots[i].time, {middle.position, middle.velocity}) / (h * h);
      const double error = std::abs(middle.acceleration - drive.acceleration);
      const double part = error / (kInterpolationError * drive.span + rounding);
      if (!std::isfinite(part)) return std::numeric_limits<double>::infinity();  // so long that it ran away
      largest = std::max(largest, part);
    }
    return largest;
  }

  /// Whether the bound on the arc's sixth derivative says that quintics keep to it between any two of its knots: half
  /// way they depart from its acceleration by that times h^4 / 1920.
  bool is_smooth(const Arc& arc, std::span<const Knot> knots) const {
    double speed = 0.0;
    double acceleration = 0.0;
    for (const Knot& knot : knots) {
      speed = std::max(speed, std::abs(knot.velocity));
      acceleration = std::max(acceleration, std::abs(knot.acceleration));
    }
    const double h = (knots.back().time - knots.front().time) / static_cast<double>(knots.size() - 1);
    const double most = kSmoothReserve * system_.most_sixth_derivative(speed, acceleration);
    const double span = system_.drive(std::nullopt, arc.start).span;
    return most * h * h * h * h / 1920.0 <= kInterpolationError * span;
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
    player.hold(motion.profile.start_state(), motion.start_time);
    player.move(motion);
  }
  const JointState goal = motions.back().profile.goal_state();
  player.hold(goal, duration);
  player.end_in(goal);
  return player.finish(motions);
}

}  // namespace dualarm
