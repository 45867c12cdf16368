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

bool is_plain(const System& system) {
  for (const double direction : {-1.0, 1.0}) {
    if (system.velocity_matters(Extreme::kLowest, direction)) return false;
    if (system.velocity_matters(Extreme::kHighest, direction)) return false;
  }
  return system.position_bends(system.range()).empty() && is_strong(system);
}

/// One end of the accelerations from one state on, forwards or backwards in time: a curve of energy over position.
struct Curve {
  const System& system;
  Extreme extreme;
  JointState anchor;

  double energy(double position) const {
    return energy_of(anchor) + system.specific_work(extreme, anchor.position, position - anchor.position);
  }
  double acceleration(double position) const { return system.extreme_acceleration(extreme, position, 0.0); }

  /// Where the curve turns at rest, beyond the anchor towards less energy; nothing beside the anchor or beyond the
  /// range.
  std::optional<double> turn() const {
    double position = anchor.position;
    for (int i = 0; i < kMostSteps; ++i) {
      const double step = -energy(position) / acceleration(position);
      position += step;
      if (!system.range().contains(position)) return std::nullopt;
      if (std::abs(step) > kLastStep * (1.0 + std::abs(position))) continue;
      return std::abs(position - anchor.position) > kShort * (1.0 + std::abs(position)) ? std::optional(position)
                                                                                        : std::nullopt;
    }
    return std::nullopt;
  }
};

/// The motion that is driven to one side first (+1 or -1), and to the other one after its switch.
class OneSwitch {
 public:
  OneSwitch(const System& system, JointState start, JointState goal, double side)
      : before_{system, side > 0.0 ? Extreme::kHighest : Extreme::kLowest, start},
        after_{system, side > 0.0 ? Extreme::kLowest : Extreme::kHighest, goal},
        side_(side) {
    // The curves' difference grows at the difference of both ends, which is the same everywhere without bends.
    const double gain = before_.acceleration(start.position) - after_.acceleration(start.position);
    const double missing = after_.energy(start.position) - energy_of(start);
    const double beyond = before_.energy(goal.position) - energy_of(goal);
    switch_.position =
        std::abs(missing) < std::abs(beyond) ? start.position + missing / gain : goal.position - beyond / gain;
  }

  /// Whether the switch lies on the way: after a start that moves to this side, before a goal that does.
  bool exists() const {
    const auto is_passed = [&](const JointState& state, double ahead) {
      return side_ * state.velocity < 0.0 || side_ * ahead > 0.0;
    };
    return is_passed(before_.anchor, switch_.position - before_.anchor.position) &&
           is_passed(after_.anchor, after_.anchor.position - switch_.position) &&
           before_.energy(switch_.position) > 0.0;
  }

  std::optional<std::vector<Arc>> arcs() {
    if (!find_velocity()) return std::nullopt;
    std::vector<Arc> arcs;
    arcs.reserve(4);
    JointState from = before_.anchor;
    if (side_ * from.velocity < 0.0) {
      const auto turn = before_.turn();
      if (!turn) return std::nullopt;
      arcs.push_back({ArcKind::kBrake, 0.0, 0.0, from, {*turn, 0.0}});
      from = arcs.back().end;
    }
    arcs.push_back({ArcKind::kAccelerate, 0.0, 0.0, from, switch_});
    JointState to = after_.anchor;
    if (side_ * to.velocity < 0.0) {
      const auto turn = after_.turn();
      if (!turn) return std::nullopt;
      to = {*turn, 0.0};
    }
    arcs.push_back({ArcKind::kBrake, 0.0, 0.0, switch_, to});
    if (to != after_.anchor) arcs.push_back({ArcKind::kAccelerate, 0.0, 0.0, to, after_.anchor});
    const auto is_short = [](const Arc& arc) {
      return std::abs(arc.end.position - arc.start.position) <= kShort * (1.0 + std::abs(arc.end.position));
    };
    if (std::any_of(arcs.begin(), arcs.end(), is_short)) return std::nullopt;
    return arcs;
  }

 private:
  /// The gentler curve knows the velocity in the switch better: its energy changes less with the position's rounding.
  bool find_velocity() {
    const double position = switch_.position;
    const double energy_before = before_.energy(position);
    const double energy_after = after_.energy(position);
    const double limit = side_ > 0.0 ? before_.system.velocity().upper : before_.system.velocity().lower;
    const double energy = std::abs(before_.acceleration(position)) < std::abs(after_.acceleration(position))
                              ? energy_before
                              : energy_after;
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
  if (!is_plain(system)) return std::nullopt;
  OneSwitch up(system, start, goal, 1.0);
  OneSwitch down(system, start, goal, -1.0);
  if (up.exists() == down.exists()) return std::nullopt;
  return up.exists() ? up.arcs() : down.arcs();
}

}  // namespace dualarm
