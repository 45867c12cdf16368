#include "core/phase_plane/portrait.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "core/phase_plane/ceiling.h"
#include "core/phase_plane/path.h"
#include "core/phase_plane/stretches.h"

namespace dualarm {
namespace {

/// Part of the range by which an arc that would take for ever to come to its standstill is begun before it. The error
/// dies out along the way back.
constexpr double kBesideStandstill = 1e-12;

double braking_at_rest(const Path& path, double x) { return path.acceleration(ArcKind::kBrake, x, 0.0); }

/// Walks backwards from the range's end and collects, stretch by stretch, the highest energy from which full braking
/// keeps range and velocity limit: like braking_ceiling, but where an arc comes down to rest, everything before it is
/// driven into what comes after, and the walk goes on where braking holds the system at rest again.
class LimitWalk {
 public:
  explicit LimitWalk(const Path& path) : path_(path), x_(path.length()) {}

  std::vector<Stretch> run() {
    while (const std::optional<Interval> held = held_at_rest()) {
      BrakingWalk walk = walk_back(path_, beginning(*held), 0.0);
      std::move(walk.stretches.begin(), walk.stretches.end(), std::back_inserter(stretches_));
      x_ = std::min(walk.end, held->lower);  // only rounding lets an arc end in between
    }
    return {std::make_move_iterator(stretches_.rbegin()), std::make_move_iterator(stretches_.rend())};
  }

 private:
  /// The last piece up to x over which braking holds the system at rest.
  std::optional<Interval> held_at_rest() const {
    if (x_ <= 0.0) return std::nullopt;
    const std::vector<double> cuts = path_.pieces(ArcKind::kBrake, 0.0, 0.0, x_);
    for (std::size_t i = cuts.size() - 1; i > 0; --i) {
      if (braking_at_rest(path_, 0.5 * (cuts[i - 1] + cuts[i])) < 0.0) return Interval{cuts[i - 1], cuts[i]};
    }
    return std::nullopt;
  }

  /// The end of a piece over which braking holds; before it, where the velocity matters and braking vanishes there.
  double beginning(const Interval& held) const {
    if (!path_.velocity_matters(ArcKind::kBrake)) return held.upper;
    const double middle = 0.5 * (held.lower + held.upper);
    const double vanishing = kBesideStandstill * braking_at_rest(path_, middle);
    double x = held.upper;
    for (double apart = kBesideStandstill * path_.length(); x > middle && braking_at_rest(path_, x) > vanishing;
         apart *= 2.0)
      x = std::max(held.upper - apart, middle);
    return x;
  }

  const Path& path_;
  double x_;
  std::vector<Stretch> stretches_;  // x descends
};

std::vector<JointState> states_of(const Path& path, const std::vector<Stretch>& curve, int resolution) {
  if (curve.empty()) return {};
  std::vector<JointState> states;
  states.reserve(static_cast<std::size_t>(resolution));
  auto stretch = curve.begin();
  for (int k = 0; k < resolution; ++k) {
    const double x =
        k + 1 < resolution ? std::lerp(curve.front().from, curve.back().to, k / (resolution - 1.0)) : curve.back().to;
    while (stretch->to < x) ++stretch;
    if (x < stretch->from) continue;  // between two stretches not even rest is safe
    const double energy = std::min(stretch->energy_at(path, x), path.energy_limit());
    states.push_back({path.position(x), path.velocity(energy)});
  }
  if (path.direction() < 0.0) std::reverse(states.begin(), states.end());
  return states;
}

std::vector<JointState> limit_curve(const System& system, double direction, int resolution) {
  const auto [start, end] = direction > 0.0 ? std::pair(system.range().lower, system.range().upper)
                                            : std::pair(system.range().upper, system.range().lower);
  const Path path(system, start, end);
  return states_of(path, LimitWalk(path).run(), resolution);
}

std::vector<JointState> switching_curve(const System& system, JointState goal, double direction, int resolution) {
  const double start = direction > 0.0 ? system.range().lower : system.range().upper;
  if (!system.range().contains(goal.position) || goal.position == start) return {};
  const Path path(system, start, goal.position);
  const double energy = energy_of(goal);
  if (direction * goal.velocity < 0.0 || energy > path.energy_limit()) return {};
  if (goal.velocity == 0.0 && !(braking_at_rest(path, path.length()) < 0.0)) return {};
  const Extremal arc(path, ArcKind::kBrake, path.length(), energy, 0.0);
  if (!(arc.end() < path.length())) return {};
  return states_of(path, {{arc, arc.end(), path.length()}}, resolution);
}

}  // namespace

PhasePortrait draw_portrait(const System& system, JointState goal, int resolution) {
  return {limit_curve(system, 1.0, resolution), limit_curve(system, -1.0, resolution),
          switching_curve(system, goal, 1.0, resolution), switching_curve(system, goal, -1.0, resolution)};
}

}  // namespace dualarm
