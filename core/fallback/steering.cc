#include "core/fallback/steering.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <variant>

#include "core/phase_plane/time_optimal.h"

namespace dualarm {

std::optional<Profile> steer(const System& system, double from, double to) {
  if (from == to) return Profile(system, from);
  auto motion = fastest_motion(system, from, to, Swings::kSkip);
  if (auto* fastest = std::get_if<FastestMotion>(&motion)) return std::move(fastest->profile);
  return std::nullopt;
}

double monotone_time(const Systems& systems, const JointPair& from, const JointPair& to) {
  double slower = 0.0;
  for (int arm = 0; arm < kArmCount; ++arm) {
    const auto profile = steer(*systems[arm], from[arm], to[arm]);
    if (!profile) return std::numeric_limits<double>::infinity();
    slower = std::max(slower, profile->duration());
  }
  return slower;
}

double minimum_time(const Systems& systems, const JointPair& from, const JointPair& to) {
  double bound = 0.0;
  for (int arm = 0; arm < kArmCount; ++arm) {
    const auto motion = fastest_motion(*systems[arm], from[arm], to[arm], Swings::kSkip);
    if (const auto* blocked = std::get_if<Blocked>(&motion)) {
      bound = std::max(bound, blocked->is_proven ? std::numeric_limits<double>::infinity() : blocked->lower_bound);
    } else {
      bound = std::max(bound, std::get<FastestMotion>(motion).lower_bound);
    }
  }
  return bound;
}

bool holdable(const Systems& systems, const JointPair& positions) {
  for (int arm = 0; arm < kArmCount; ++arm) {
    if (!systems[arm]->range().contains(positions[arm])) return false;
    if (!systems[arm]->acceleration(positions[arm], 0.0).contains(0.0)) return false;
  }
  return true;
}

}  // namespace dualarm
