#include "core/phase_plane/one_switch.h"

#include <algorithm>
#include <cmath>

#include "core/phase_plane/minimum.h"
#include "core/phase_plane/path.h"

namespace dualarm {
namespace {

/// Length (rad, at 1 rad) below which an arc is left to those who look at its rounding.
constexpr double kShort = 1e-6;
/// Part of the energy in the switch by which both curves may differ there: some roundings of the work.
constexpr double kSameEnergy = 1e-13;
/// Part of the energy limit beyond which the switch counts as one on the limit.
constexpr double kBelowLimit = 1.0 - 1e-9;
/// Newton steps towards a turning point: the energy is nearly linear in the position, digits double with each.
constexpr int kMostSteps = 12;
/// Step (rad, at 1 rad) of that search which is rounding.
constexpr double kLastStep = 4e-16;

/// One end of the accelerations from one state on, forwards or backwards in time: a curve of energy over position.
struct Curve {
  SineWork work;
  JointState anchor;

  double energy(double position) const { return energy_of(anchor) + work.over(position - anchor.position); }
  double acceleration(double position) const { return work.rate(position - anchor.position); }

  /// Where the curve turns at rest, beyond the anchor towards less energy; nothing beside the anchor.
  std::optional<double> turn() const {
    double change = 0.0;
    for (int i = 0; i < kMostSteps; ++i) {
      const double step = -(energy_of(anchor) + work.over(change)) / work.rate(change);
      change += step;
      const double size = 1.0 + std::abs(anchor.position);
      if (std::abs(step) > kLastStep * size) continue;
      return std::abs(change) > kShort * size ? std::optional(anchor.position + change) : std::nullopt;
    }
    return std::nullopt;
  }
};

/// Whether positions are apart, next to each other, or the other way round, seen along a direction (+1 or -1).
enum class Order { kBehind, kNextTo, kAhead };

Order order_of(double position, double other, double direction) {
  const double ahead = direction * (other - position);
  if (std::abs(ahead) <= kShort * (1.0 + std::abs(position))) return Order::kNextTo;
  return ahead > 0.0 ? Order::kAhead : Order::kBehind;
}

/// Whether a motion leads to the goal; unsure where a rounding decides.
enum class Existence { kNo, kUnsure, kYes };

/// The motion that is driven to one side first (+1 or -1), and to the other one after its switch.
class OneSwitch {
 public:
  /// `work` (rad/s)2: of both curves from the start to the goal.
  OneSwitch(const Curve& before, const Curve& after, double work_before, double work_after, double side)
      : before_(before), after_(after), side_(side) {
    // Without bends the curves' difference grows alike everywhere.
    const double gain = before.work.constant - after.work.constant;
    const double lift = energy_of(after.anchor) - energy_of(before.anchor);
    const double from_start = (lift - work_after) / gain;
    const double to_goal = (work_before - lift) / gain;
    switch_.position = std::abs(from_start) < std::abs(to_goal) ? before.anchor.position + from_start
                                                                : after.anchor.position - to_goal;
  }

  /// The switch lies on the way after a start that moves to this side, before a goal that does, and where the motion
  /// has not come to rest yet.
  Existence existence() const {
    const bool comes_back = side_ * before_.anchor.velocity < 0.0;
    const bool goes_back = side_ * after_.anchor.velocity < 0.0;
    const Order from_start = order_of(before_.anchor.position, switch_.position, side_);
    const Order to_goal = order_of(switch_.position, after_.anchor.position, side_);
    // Next to an end the other motion may be the same one with a loop to and fro in that end, which takes longer.
    if (from_start == Order::kNextTo || to_goal == Order::kNextTo) return Existence::kUnsure;
    if (!comes_back && from_start == Order::kBehind) return Existence::kNo;
    if (!goes_back && to_goal == Order::kBehind) return Existence::kNo;
    return !comes_back || !goes_back || before_.energy(switch_.position) > 0.0 ? Existence::kYes : Existence::kNo;
  }

  std::optional<std::vector<Arc>> arcs(const System& system) {
    if (!find_velocity(side_ > 0.0 ? system.velocity().upper : system.velocity().lower)) return std::nullopt;
    const std::optional<JointState> first = turning(before_);
    const std::optional<JointState> last = turning(after_);
    if (!first || !last) return std::nullopt;
    const Interval range = system.range();
    if (!range.contains(first->position) || !range.contains(last->position)) return std::nullopt;
    std::vector<Arc> arcs;
    arcs.reserve(4);
    if (*first != before_.anchor) arcs.push_back({ArcKind::kBrake, 0.0, 0.0, before_.anchor, *first});
    arcs.push_back({ArcKind::kAccelerate, 0.0, 0.0, *first, switch_});
    arcs.push_back({ArcKind::kBrake, 0.0, 0.0, switch_, *last});
    if (*last != after_.anchor) arcs.push_back({ArcKind::kAccelerate, 0.0, 0.0, *last, after_.anchor});
    const auto is_short = [](const Arc& arc) {
      return std::abs(arc.end.position - arc.start.position) <= kShort * (1.0 + std::abs(arc.end.position));
    };
    if (std::any_of(arcs.begin(), arcs.end(), is_short)) return std::nullopt;
    return arcs;
  }

 private:
  /// Where the motion along a curve turns between its anchor and the switch; the anchor itself if it does not.
  std::optional<JointState> turning(const Curve& curve) const {
    if (side_ * curve.anchor.velocity >= 0.0) return curve.anchor;
    const auto turn = curve.turn();
    return turn ? std::optional(JointState{*turn, 0.0}) : std::nullopt;
  }

  /// The gentler curve knows the velocity in the switch better: its energy changes less with the position's rounding.
  bool find_velocity(double limit) {
    const double position = switch_.position;
    const double energy_before = before_.energy(position);
    const double energy_after = after_.energy(position);
    const bool is_gentler = std::abs(before_.acceleration(position)) < std::abs(after_.acceleration(position));
    const double energy = is_gentler ? energy_before : energy_after;
    if (!(std::abs(energy_before - energy_after) <= kSameEnergy * energy)) return false;
    if (!(energy <= 0.5 * limit * limit * kBelowLimit)) return false;
    switch_.velocity = side_ * std::sqrt(2.0 * energy);
    return true;
  }

  Curve before_;
  Curve after_;
  double side_;
  JointState switch_;
};

}  // namespace

std::optional<std::vector<Arc>> one_switch_motion(const System& system, JointState start, JointState goal) {
  if (depends_on_velocity(system) || !is_strong(system)) return std::nullopt;
  const auto curve = [&](Extreme extreme, JointState anchor) -> std::optional<Curve> {
    const auto work = system.work_from(extreme, anchor.position);
    return work ? std::optional(Curve{*work, anchor}) : std::nullopt;
  };
  const auto up_from_start = curve(Extreme::kHighest, start);
  const auto down_from_start = curve(Extreme::kLowest, start);
  const auto up_to_goal = curve(Extreme::kHighest, goal);
  const auto down_to_goal = curve(Extreme::kLowest, goal);
  if (!up_from_start || !down_from_start || !up_to_goal || !down_to_goal) return std::nullopt;
  const double change = goal.position - start.position;
  const double up_work = up_from_start->work.over(change);
  const double down_work = down_from_start->work.over(change);
  OneSwitch up(*up_from_start, *down_to_goal, up_work, down_work, 1.0);
  OneSwitch down(*down_from_start, *up_to_goal, down_work, up_work, -1.0);
  const Existence of_up = up.existence();
  const Existence of_down = down.existence();
  if (of_up == of_down || of_up == Existence::kUnsure || of_down == Existence::kUnsure) return std::nullopt;
  return of_up == Existence::kYes ? up.arcs(system) : down.arcs(system);
}

}  // namespace dualarm
