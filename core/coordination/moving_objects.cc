#include "core/coordination/moving_objects.h"

#include <utility>

#include "core/coordination/projection.h"
#include "core/coordination/traffic.h"

namespace dualarm {

std::optional<IntervalSet> forbidden_starts(const Profile& motion, const Base& base, const std::vector<Body>& bodies,
                                            const std::vector<TrackedBody>& objects, double clearance,
                                            const Budget& budget) {
  if (objects.empty()) return IntervalSet();
  const Traffic traffic(base, bodies, objects, clearance, budget);
  const bool stays = motion.goal_state().velocity == 0.0;
  const auto differences = project(traffic, motion, {motion.duration(), stays}, budget);
  if (!differences) return std::nullopt;
  std::vector<Interval> starts;
  for (const Interval& own_minus_other : differences->intervals()) {
    starts.push_back({-own_minus_other.upper, -own_minus_other.lower});
  }
  return IntervalSet(std::move(starts));
}

}  // namespace dualarm
