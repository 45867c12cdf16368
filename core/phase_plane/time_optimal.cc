#include "core/phase_plane/time_optimal.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "core/phase_plane/arc_motion.h"
#include "core/phase_plane/impasse.h"
#include "core/phase_plane/minimum.h"
#include "core/phase_plane/one_switch.h"
#include "core/phase_plane/spot_motion.h"
#include "core/phase_plane/swing.h"
#include "core/phase_plane/turns.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::optional<Blocked> check_start(const System& system, JointState state) {
  if (!system.range().contains(state.position)) {
    return Blocked{BlockReason::kStartOutsideRange, state.position, state.velocity};
  }
  if (!system.velocity().contains(state.velocity)) {
    return Blocked{BlockReason::kStartTooFast, state.position, state.velocity};
  }
  if (state.velocity != 0.0) return std::nullopt;
  const Interval admissible = system.acceleration(state.position, 0.0);
  if (admissible.lower > 0.0) return Blocked{BlockReason::kStartNotHoldable, state.position, 0.0, Extreme::kLowest};
  if (admissible.upper < 0.0) return Blocked{BlockReason::kStartNotHoldable, state.position, 0.0, Extreme::kHighest};
  return std::nullopt;
}

std::optional<Blocked> check_goal(const System& system, JointState state) {
  auto blocked = check_start(system, state);
  if (!blocked) return std::nullopt;
  blocked->reason = blocked->reason == BlockReason::kStartOutsideRange ? BlockReason::kGoalOutsideRange
                    : blocked->reason == BlockReason::kStartTooFast    ? BlockReason::kGoalTooFast
                                                                       : BlockReason::kGoalNotHoldable;
  return blocked;
}

Profile profile_of(const System& system, JointState start, std::vector<Arc> arcs) {
  return arcs.empty() ? Profile(system, start) : Profile(system, std::move(arcs));
}

/// The faster of the two ways, or what is in the way of the one that comes further.
std::variant<Profile, Blocked> faster_way(const System& system, JointState start, JointState goal) {
  if (auto arcs = motion_on_the_spot(system, start, goal)) return profile_of(system, start, std::move(*arcs));
  if (auto arcs = one_switch_motion(system, start, goal)) return profile_of(system, start, std::move(*arcs));
  std::optional<Profile> fastest;
  std::optional<Blocked> obstacle;
  const double natural = goal.position >= start.position ? 1.0 : -1.0;
  for (const double direction : {natural, -natural}) {
    auto way = one_way_motion(system, start, goal, direction);
    if (!way) continue;
    if (const auto* blocked = std::get_if<Blocked>(&*way)) {
      if (!obstacle || tells_more(system, *blocked, *obstacle)) obstacle = *blocked;
      continue;
    }
    Profile profile = profile_of(system, start, std::move(std::get<std::vector<Arc>>(*way)));
    if (!fastest || profile.duration() < fastest->duration()) fastest = std::move(profile);
  }
  if (fastest) return std::move(*fastest);
  return obstacle.value_or(Blocked{BlockReason::kStalls, start.position, start.velocity, Extreme::kHighest, false});
}

MinimumOver claim_of(const System& system, const Profile& profile, double bound, Swings swings) {
  if (profile.stands_still() || profile.duration() <= bound) return MinimumOver::kAllMotions;
  if (is_minimum_by_duration(system, profile.duration())) return MinimumOver::kAllMotions;
  if (swings == Swings::kSearch && is_minimum_by_run_up(system, profile)) return MinimumOver::kAllMotions;
  return profile.legs().size() == 1 ? MinimumOver::kMonotoneMotions : MinimumOver::kSearchedMotions;
}

double duration_along(const System& system, const std::vector<Arc>& arcs) {
  double duration = 0.0;
  for (const Arc& arc : arcs) duration += ArcMotion(system, arc, ArcMotion::kLean).duration();
  return duration;
}

}  // namespace

std::variant<FastestMotion, Blocked> fastest_motion(const System& system, JointState start, JointState goal,
                                                    Swings swings, const Budget& budget) {
  if (const auto blocked = check_start(system, start)) return *blocked;
  if (const auto blocked = check_goal(system, goal)) return *blocked;
  auto way = faster_way(system, start, goal);
  const double bound = Relaxation(system, start, goal).duration(start, goal);
  if (auto* profile = std::get_if<Profile>(&way)) {
    const MinimumOver claim = claim_of(system, *profile, bound, swings);
    const bool is_proven = claim == MinimumOver::kAllMotions;
    if (!is_proven && swings == Swings::kSearch) {
      if (auto swing = fastest_swing(system, start, goal, profile->duration(), budget)) {
        return FastestMotion{std::move(*swing), MinimumOver::kSearchedMotions, bound};
      }
    }
    const double duration = profile->duration();
    return FastestMotion{std::move(*profile), claim, is_proven ? duration : bound};
  }
  Blocked blocked = std::get<Blocked>(way);
  if (const auto proven = impasse(system, start, goal, blocked)) {
    blocked = *proven;
  } else {
    blocked.is_proven = false;
  }
  blocked.lower_bound = bound;
  if (!blocked.is_proven && swings == Swings::kSearch) {
    if (auto swing = fastest_swing(system, start, goal, kInfinity, budget)) {
      return FastestMotion{std::move(*swing), MinimumOver::kSearchedMotions, bound};
    }
    blocked.is_searched_out = !budget.exhausted();
  }
  return blocked;
}

double fastest_duration(const System& system, JointState start, JointState goal) {
  if (check_start(system, start) || check_goal(system, goal)) return kInfinity;
  if (const auto arcs = motion_on_the_spot(system, start, goal)) return duration_along(system, *arcs);
  if (const auto arcs = one_switch_motion(system, start, goal)) return duration_along(system, *arcs);
  double fastest = kInfinity;
  for (const double direction : {1.0, -1.0}) {
    const auto way = one_way_motion(system, start, goal, direction);
    const auto* arcs = way ? std::get_if<std::vector<Arc>>(&*way) : nullptr;
    if (arcs != nullptr) fastest = std::min(fastest, duration_along(system, *arcs));
  }
  return fastest;
}

}  // namespace dualarm
