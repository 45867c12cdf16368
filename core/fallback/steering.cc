#include "core/fallback/steering.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "core/phase_plane/time_optimal.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// s. What is left of an arc that is cut lasts at least this: its velocities then differ by more than rounding.
constexpr double kShortestArc = 1e-6;

/// Part of a duration by which a stretched motion may miss it: what quadratures leave. Knots that are meant to share a
/// time have to (playback.h allows 1e-12).
constexpr double kSameDuration = 2e-13;

/// Where on the fastest motion, as shares of its time, a stretched one is slower.
constexpr std::array<double, 3> kSlowPlaces = {0.5, 0.25, 0.75};

/// Halvings of a share of a speed: as far as double precision goes.
constexpr int kHalvings = 60;

}  // namespace

std::optional<Profile> steer(const System& system, JointState from, JointState to) {
  if (from == to) return Profile(system, from);
  auto motion = fastest_motion(system, from, to, Swings::kSkip);
  if (auto* fastest = std::get_if<FastestMotion>(&motion)) return std::move(fastest->profile);
  return std::nullopt;
}

double steering_time(const System& system, JointState from, JointState to) {
  return from == to ? 0.0 : fastest_duration(system, from, to);
}

std::optional<Profile> cut(const System& system, const Profile& motion, double time) {
  std::vector<Arc> arcs;
  for (const Arc& arc : motion.arcs()) {
    if (arc.end_time <= time) {
      arcs.push_back(arc);
      continue;
    }
    if (time - arc.start_time < kShortestArc || arc.end_time - time < kShortestArc) return std::nullopt;
    Arc part = arc;
    part.end = motion.at(time);
    part.end.velocity = std::clamp(part.end.velocity, system.velocity().lower, system.velocity().upper);  // to rounding
    arcs.push_back(part);
    return Profile(system, std::move(arcs));
  }
  return std::nullopt;
}

std::optional<std::vector<Profile>> stretched(const System& system, JointState from, JointState to, double duration) {
  auto fastest = steer(system, from, to);
  if (!fastest) return std::nullopt;
  const double allowed = kSameDuration * duration;
  if (std::abs(fastest->duration() - duration) <= allowed) return std::vector<Profile>{std::move(*fastest)};
  if (fastest->duration() > duration) return std::nullopt;
  for (const double place : kSlowPlaces) {
    const JointState passed = fastest->at(place * fastest->duration());
    const auto slower = [&](double share) { return JointState{passed.position, share * passed.velocity}; };
    const auto excess = [&](double share) {
      return steering_time(system, from, slower(share)) + steering_time(system, slower(share), to) - duration;
    };
    double slow = 0.0;
    double quick = 1.0;
    if (!(excess(slow) >= 0.0)) continue;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (slow + quick);
      (excess(middle) > 0.0 ? slow : quick) = middle;
    }
    auto before = steer(system, from, slower(quick));
    auto after = steer(system, slower(quick), to);
    if (!before || !after || std::abs(before->duration() + after->duration() - duration) > allowed) continue;
    return std::vector<Profile>{std::move(*before), std::move(*after)};
  }
  return std::nullopt;
}

double steering_time(const Systems& systems, const JointStates& from, const JointStates& to) {
  const double first = steering_time(*systems[0], from[0], to[0]);
  return std::isinf(first) ? first : std::max(first, steering_time(*systems[1], from[1], to[1]));
}

double minimum_time(const Systems& systems, const JointStates& from, const JointStates& to) {
  double bound = 0.0;
  for (int arm = 0; arm < kArmCount; ++arm) {
    const auto motion = fastest_motion(*systems[arm], from[arm], to[arm], Swings::kSkip);
    if (const auto* blocked = std::get_if<Blocked>(&motion)) {
      bound = std::max(bound, blocked->is_proven ? kInfinity : blocked->lower_bound);
    } else {
      bound = std::max(bound, std::get<FastestMotion>(motion).lower_bound);
    }
  }
  return bound;
}

bool can_hold(const System& system, JointState state) {
  return state.velocity == 0.0 && system.range().contains(state.position) &&
         system.acceleration(state.position, 0.0).contains(0.0);
}

}  // namespace dualarm
