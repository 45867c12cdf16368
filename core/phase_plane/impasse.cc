#include "core/phase_plane/impasse.h"

#include <algorithm>
#include <cmath>

#include "core/phase_plane/limited_energy.h"
#include "core/phase_plane/path.h"
#include "core/phase_plane/turns.h"

namespace dualarm {
namespace {

/// What two sums of work may differ by, (rad/s)2, and be the same.
constexpr double kWorkRounding = 1e-12;

/// Whether a state too fast to stop, or to run up to, was followed to the end of the range.
bool at_range_end(const System& system, const Blocked& blocked) {
  const Interval range = system.range();
  const bool upwards = (blocked.reason == BlockReason::kStartTooFast) == (blocked.velocity > 0.0);
  return blocked.position == (upwards ? range.upper : range.lower);
}

/// Least driving work from x = 0 to any x in an interval.
double least_work(const Path& path, double from, double to) {
  double least = path.work(ArcKind::kAccelerate, 0.0, from);
  for (const double x : path.pieces(ArcKind::kAccelerate, 0.0, from, to)) {
    least = std::min(least, path.work(ArcKind::kAccelerate, 0.0, x));
  }
  return least;
}

/// On its way forwards past x a motion last turned round at some q, so its energy at x is at most the driving work from
/// q to x; or it never turned, and is at most what its start had more. If that is negative from every q that the range
/// offers before x, no motion passes x; and it is, where the work from the path's start falls below everything that it
/// was before.
bool lacks_energy(const Path& path, double energy) {
  const double least_before = std::min(-energy, least_work(path, -path.room_before(), 0.0));
  return least_work(path, 0.0, path.length()) < least_before - kWorkRounding;
}

/// Time reversed, braking onto the goal is driving away from it, so both directions are one.
bool lacks_energy(const System& system, JointState start, JointState goal) {
  if (start.position == goal.position) return false;
  const Path there(system, start.position, goal.position);
  const Path back(system, goal.position, start.position);
  const auto energy = [&](JointState state) {
    return state.velocity * there.direction() > 0.0 ? energy_of(state) : 0.0;
  };
  return (system.drives_best_at_rest(there.direction()) && lacks_energy(there, energy(start))) ||
         (!there.velocity_matters(ArcKind::kBrake) && lacks_energy(back, energy(goal)));
}

int weight(const System& system, const Blocked& blocked) {
  switch (blocked.reason) {
    case BlockReason::kVelocityLimit:
      return 3;
    case BlockReason::kStartTooFast:
    case BlockReason::kGoalTooFast:
      return at_range_end(system, blocked) ? 3 : 1;
    default:
      return 2;
  }
}

}  // namespace

std::optional<Blocked> impasse(const System& system, JointState start, JointState goal, const Blocked& obstacle) {
  Blocked proven = obstacle;
  proven.is_proven = true;
  if (start.velocity != 0.0 && std::holds_alternative<Blocked>(stop_from(system, start))) return proven;
  if (goal.velocity != 0.0) {
    const auto run_up = run_up_to(system, goal);
    const auto* blocked = std::get_if<Blocked>(&run_up);
    if (blocked != nullptr && at_range_end(system, *blocked)) return proven;
  }
  if (lacks_energy(system, start, goal)) return proven;
  const auto broken = limit_break(system, start, goal);
  if (!broken) return std::nullopt;
  const bool highest = (broken->kind == ArcKind::kAccelerate) == (broken->velocity > 0.0);
  return Blocked{BlockReason::kVelocityLimit, broken->position, broken->velocity,
                 highest ? Extreme::kHighest : Extreme::kLowest};
}

bool tells_more(const System& system, const Blocked& obstacle, const Blocked& other) {
  return weight(system, obstacle) > weight(system, other);
}

}  // namespace dualarm
