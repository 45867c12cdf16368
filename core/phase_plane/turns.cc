#include "core/phase_plane/turns.h"

#include <algorithm>
#include <cmath>

#include "core/phase_plane/spot_motion.h"
#include "core/phase_plane/stretches.h"

namespace dualarm {
namespace {

/// Length (rad, at 1 rad) below which an arc is rounding, a few last digits of its ends, and the part of its leg that
/// it has to be below, too.
constexpr double kShortestArc = 1e-15;
constexpr double kShortestShare = 1e-3;
/// Part of its own speed below which what such an arc gains is rounding, too. A larger gain takes time.
constexpr double kShortestGain = 1e-10;
/// By what factor an arc is faster on its way than at both its ends where it is cut: seen from either end the other one
/// would be a singularity of the time.
constexpr double kSwell = 10.0;
constexpr std::size_t kUsualArcs = 4;  ///< of a leg, at most

Blocked blocked_by(const Obstruction& obstruction, const Path& path, JointState to) {
  const double position = path.position(obstruction.x);
  switch (obstruction.kind) {
    case Obstruction::Kind::kStalls:
      return {BlockReason::kStalls, position, 0.0, path.extreme(ArcKind::kAccelerate)};
    case Obstruction::Kind::kCannotBrake:
      return {BlockReason::kCannotBrake, position, 0.0, path.extreme(ArcKind::kBrake)};
    case Obstruction::Kind::kOverspeeds:
      return {BlockReason::kCannotBrake, to.position, to.velocity, path.extreme(ArcKind::kBrake)};
    case Obstruction::Kind::kFallsShort:
      return {BlockReason::kGoalTooFast, to.position, to.velocity, path.extreme(ArcKind::kAccelerate)};
  }
  throw std::logic_error("unknown obstruction");
}

/// The stretches as arcs, cut where the accelerations bend; where two meet, both take the state of the meeting point.
class ArcChain {
 public:
  ArcChain(const Path& path, JointState from, JointState to)
      : path_(path),
        from_(from),
        shortest_(std::min(kShortestArc * (1.0 + std::abs(to.position)),
                           kShortestShare * std::abs(to.position - from.position))) {
    arcs_.reserve(kUsualArcs);
  }

  /// `next` is the stretch that follows, if any.
  void add(const Stretch& stretch, const Stretch* next = nullptr) {
    const ArcKind kind = kind_of(stretch);
    if (stretch.arc) {
      for (const double x : cuts_of(*stretch.arc, stretch.from, stretch.to)) {
        append(kind, {path_.position(x), path_.velocity(stretch.energy_at(path_, x))});
      }
    }
    append(kind, {path_.position(stretch.to), path_.velocity(meeting_energy(stretch, next))});
  }

  /// The arcs, the last one brought to the very state where they have to end.
  std::vector<Arc> end_in(JointState to) && {
    if (!arcs_.empty()) arcs_.back().end = to;
    return std::move(arcs_);
  }

 private:
  /// Where an arc is cut: at its bends, and where it is fastest, if it swells from next to rest and ebbs back to it.
  std::vector<double> cuts_of(const Extremal& arc, double from, double to) const {
    std::vector<double> cuts = arc.bends(from, to);
    if (path_.velocity_matters(arc.kind())) return cuts;
    const double first = arc.energy_at(from);
    const double last = arc.energy_at(to);
    if (path_.acceleration(arc.kind(), from, first) <= 0.0 || path_.acceleration(arc.kind(), to, last) >= 0.0) {
      return cuts;
    }
    const double fastest = arc.fastest_between(from, to);
    if (arc.energy_at(fastest) <= kSwell * kSwell * std::max(first, last)) return cuts;
    cuts.insert(std::lower_bound(cuts.begin(), cuts.end(), fastest), fastest);
    return cuts;
  }

  /// A stretch on the limit so short that it does not show that the limit cannot be held there is none of a cruise: no
  /// torque does that.
  ArcKind kind_of(const Stretch& stretch) const {
    if (stretch.arc) return stretch.arc->kind();
    const double middle = 0.5 * (stretch.from + stretch.to);
    if (path_.acceleration(ArcKind::kAccelerate, middle, path_.energy_limit()) < 0.0) return ArcKind::kAccelerate;
    if (path_.acceleration(ArcKind::kBrake, middle, path_.energy_limit()) > 0.0) return ArcKind::kBrake;
    return ArcKind::kCruise;
  }

  /// Energy where a stretch meets the next one. Both know it but for the rounding of the position times their
  /// acceleration: the gentler one knows it better, and its time depends on it.
  double meeting_energy(const Stretch& stretch, const Stretch* next) const {
    const double energy = stretch.energy_at(path_, stretch.to);
    if (next == nullptr || !stretch.arc || !next->arc) return energy;
    const auto steepness = [&](const Stretch& s) { return std::abs(path_.acceleration(s.kind(), stretch.to, energy)); };
    return steepness(*next) < steepness(stretch) ? next->energy_at(path_, stretch.to) : energy;
  }

  void append(ArcKind kind, JointState to) {
    const double fastest = std::max(std::abs(to.velocity), std::abs(from_.velocity));
    if (std::abs(to.position - from_.position) <= shortest_ &&
        std::abs(to.velocity - from_.velocity) <= kShortestGain * fastest) {
      from_.velocity = to.velocity;
      if (!arcs_.empty()) arcs_.back().end.velocity = to.velocity;
      return;
    }
    // A cruise keeps the velocity it begins with, whatever rounding says.
    if (kind == ArcKind::kCruise && from_.velocity != 0.0) to.velocity = from_.velocity;
    arcs_.push_back({kind, 0.0, 0.0, from_, to});
    from_ = to;
  }

  const Path& path_;
  JointState from_;
  double shortest_;  ///< rad, of an arc
  std::vector<Arc> arcs_;
};

void append(std::vector<Arc>& arcs, std::vector<Arc>&& more) {
  if (arcs.empty()) {
    arcs = std::move(more);
  } else {
    arcs.insert(arcs.end(), more.begin(), more.end());
  }
}

/// One leg from one state to another, which do not point against it.
std::optional<Blocked> append_leg(const System& system, JointState from, JointState to, std::vector<Arc>& arcs) {
  const Path path(system, from.position, to.position);
  const auto found = fastest_stretches(path, energy_of(from), energy_of(to));
  if (const auto* obstruction = std::get_if<Obstruction>(&found)) return blocked_by(*obstruction, path, to);
  ArcChain chain(path, from, to);
  const auto& stretches = std::get<std::vector<Stretch>>(found);
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    chain.add(stretches[i], i + 1 < stretches.size() ? &stretches[i + 1] : nullptr);
  }
  append(arcs, std::move(chain).end_in(to));
  return std::nullopt;
}

/// A single extremal as arcs.
std::vector<Arc> arcs_along(const Path& path, const Extremal& extremal, JointState from, JointState to) {
  ArcChain chain(path, from, to);
  const double x = path.x(from.position);
  chain.add({extremal, x, path.x(to.position)});
  return std::move(chain).end_in(to);
}

/// Whether a state is at rest as far as positions can tell: braked, as a start, or driven, as a goal, within less.
bool is_at_rest(const System& system, JointState state, bool is_start) {
  if (state.velocity == 0.0) return true;
  const Extreme extreme = (state.velocity > 0.0) == is_start ? Extreme::kLowest : Extreme::kHighest;
  const double acceleration = system.extreme_acceleration(extreme, state.position, state.velocity);
  return energy_of(state) <= std::abs(acceleration) * kShortestArc * (1.0 + std::abs(state.position));
}

/// Full braking from a moving start to rest, or full drive from rest to a moving goal, which is the same backwards in
/// time: one extremal from the state towards the end of the range that it moves to, or comes from.
ArcsOrBlocked arcs_to_rest(const System& system, JointState state, bool is_start) {
  if (is_at_rest(system, state, is_start)) return std::vector<Arc>{};
  const double wall = (state.velocity > 0.0) == is_start ? system.range().upper : system.range().lower;
  const ArcKind kind = is_start ? ArcKind::kBrake : ArcKind::kAccelerate;
  const BlockReason too_fast = is_start ? BlockReason::kStartTooFast : BlockReason::kGoalTooFast;
  if (state.position == wall) {
    const Extreme extreme = (state.velocity > 0.0) == is_start ? Extreme::kLowest : Extreme::kHighest;
    return Blocked{too_fast, wall, state.velocity, extreme};
  }
  const Path path = is_start ? Path(system, state.position, wall) : Path(system, wall, state.position);
  const Extremal arc(path, kind, path.x(state.position), energy_of(state), path.x(wall));
  const JointState rest = {path.position(arc.end()), 0.0};
  const double left = arc.energy_at(arc.end());
  if (arc.exit() == Extremal::Exit::kRest || left == 0.0) {
    return is_start ? arcs_along(path, arc, state, rest) : arcs_along(path, arc, rest, state);
  }
  const bool breaks_limit = is_start && arc.exit() == Extremal::Exit::kLimit;
  return Blocked{breaks_limit ? BlockReason::kVelocityLimit : too_fast, rest.position, path.velocity(left),
                 path.extreme(kind)};
}

}  // namespace

ArcsOrBlocked motion_through(const System& system, JointState start, const std::vector<double>& turns,
                             JointState goal) {
  std::vector<Arc> arcs;
  JointState from = start;
  for (std::size_t i = 0; i <= turns.size(); ++i) {
    const JointState to = i < turns.size() ? JointState{turns[i], 0.0} : goal;
    if (is_one_position(to.position, from.position)) {
      if (to.velocity != from.velocity) return Blocked{BlockReason::kGoalTooFast, to.position, to.velocity};
      if (!arcs.empty()) from = arcs.back().end = to;
      continue;
    }
    if (auto blocked = append_leg(system, from, to, arcs)) return *blocked;
    from = to;
  }
  return arcs;
}

ArcsOrBlocked stop_from(const System& system, JointState start) { return arcs_to_rest(system, start, true); }

ArcsOrBlocked run_up_to(const System& system, JointState goal) { return arcs_to_rest(system, goal, false); }

std::optional<ArcsOrBlocked> one_way_motion(const System& system, JointState start, JointState goal, double direction) {
  JointState from = start;
  JointState to = goal;
  ArcsOrBlocked before = std::vector<Arc>{};
  ArcsOrBlocked after = std::vector<Arc>{};
  if (direction * start.velocity < 0.0) {
    before = stop_from(system, start);
    if (std::holds_alternative<Blocked>(before)) return before;
    const auto& arcs = std::get<std::vector<Arc>>(before);
    from = {arcs.empty() ? start.position : arcs.back().end.position, 0.0};
  }
  if (direction * goal.velocity < 0.0) {
    after = run_up_to(system, goal);
    if (std::holds_alternative<Blocked>(after)) return after;
    const auto& arcs = std::get<std::vector<Arc>>(after);
    to = {arcs.empty() ? goal.position : arcs.front().start.position, 0.0};
  }
  const bool meet = is_one_position(from.position, to.position);
  if (!meet && direction * (to.position - from.position) < 0.0) return std::nullopt;
  auto& arcs = std::get<std::vector<Arc>>(before);
  if (!meet) {
    if (auto blocked = append_leg(system, from, to, arcs)) return *blocked;
  } else if (from.velocity != to.velocity) {
    return std::nullopt;
  }
  auto& last = std::get<std::vector<Arc>>(after);
  if (!arcs.empty() && !last.empty()) last.front().start = arcs.back().end;
  append(arcs, std::move(last));
  if (!arcs.empty() && arcs.front().kind != ArcKind::kCruise) arcs.front().start = start;
  if (!arcs.empty()) arcs.back().end = goal;
  return before;
}

}  // namespace dualarm
