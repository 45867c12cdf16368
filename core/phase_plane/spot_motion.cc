#include "core/phase_plane/spot_motion.h"

#include <algorithm>
#include <cmath>

#include "core/phase_plane/path.h"

namespace dualarm {
namespace {

/// Distance (rad, at 1 rad) below which two positions are one.
constexpr double kOnePosition = 2e-14;
/// rad/s: what counts as rest at both ends of a motion without length. The motion of no duration that is answered then
/// misses its end states by no more.
constexpr double kRestSpeed = 1e-8;

/// How far (rad) braking a state takes, at least.
double way_to_rest(const System& system, JointState state) {
  const Interval admissible = system.acceleration(state.position, state.velocity);
  return energy_of(state) / std::max(std::abs(admissible.lower), std::abs(admissible.upper));
}

/// Whether two states are the same, or both at rest at one position.
bool is_one_state(const System& system, JointState start, JointState goal) {
  const auto stands = [&](JointState state) {
    return std::abs(state.velocity) <= kRestSpeed && is_one_position(way_to_rest(system, state), 0.0);
  };
  if (start == goal) return true;
  return is_one_position(start.position, goal.position) && stands(start) && stands(goal);
}

/// Appends an arc of constant acceleration, cut at rest.
void append(std::vector<Arc>& arcs, JointState from, double acceleration, double velocity) {
  const auto advance = [&](double to) {
    if (to == from.velocity) return;
    const double sense = from.velocity + to;
    const ArcKind kind = sense * acceleration > 0.0 ? ArcKind::kAccelerate : ArcKind::kBrake;
    const JointState end = {from.position + 0.5 * sense * (to - from.velocity) / acceleration, to};
    arcs.push_back({kind, 0.0, 0.0, from, end});
    from = end;
  };
  if (from.velocity * velocity < 0.0) advance(0.0);
  advance(velocity);
}

}  // namespace

bool is_one_position(double position, double other) {
  return std::abs(position - other) <= kOnePosition * (1.0 + std::abs(position));
}

std::optional<std::vector<Arc>> motion_on_the_spot(const System& system, JointState start, JointState goal) {
  if (is_one_state(system, start, goal)) return std::vector<Arc>{};
  if (!is_one_position(start.position, goal.position)) return std::nullopt;
  if (!is_one_position(way_to_rest(system, start), 0.0) || !is_one_position(way_to_rest(system, goal), 0.0)) {
    return std::nullopt;
  }
  const Interval admissible = system.acceleration(start.position, 0.0);
  if (!(admissible.lower < 0.0 && admissible.upper > 0.0)) return std::nullopt;
  const double lift = energy_of(goal) - energy_of(start);
  const double travel = goal.position - start.position;
  for (const double sense : {1.0, -1.0}) {
    const double first = sense > 0.0 ? admissible.upper : admissible.lower;
    const double second = sense > 0.0 ? admissible.lower : admissible.upper;
    // Work and energy: peak/first - peak/second = travel + start/first - goal/second, in energies.
    const double peak = energy_of(start) + first * (lift - second * travel) / (first - second);
    const double velocity = sense * std::sqrt(2.0 * std::max(0.0, peak));
    if (peak < 0.0 || sense * (velocity - start.velocity) < 0.0 || sense * (velocity - goal.velocity) < 0.0) continue;
    if (!system.velocity().contains(velocity)) return std::nullopt;
    std::vector<Arc> arcs;
    append(arcs, start, first, velocity);
    append(arcs, arcs.empty() ? start : arcs.back().end, second, goal.velocity);
    if (arcs.empty()) return std::nullopt;
    arcs.back().end = goal;
    return arcs;
  }
  return std::nullopt;
}

}  // namespace dualarm
