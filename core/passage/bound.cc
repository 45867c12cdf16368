#include "core/passage/bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/passage/slowest_gate.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Slices across the fastest motions in which obstacles are looked for.
constexpr int kSeedSlices = 17;
/// Obstacles that are looked at.
constexpr std::size_t kMostObstacles = 8;

/// Adds the obstacle that a slice belongs to, if it is not known yet.
void add_obstacle(std::vector<Obstacle>& obstacles, const ForbiddenPlane& plane, const Travellers& travellers,
                  const Slice& slice, const Budget& budget) {
  const auto knows = [&](Obstacle& obstacle) { return obstacle.side_of(slice, true).has_value(); };
  if (std::any_of(obstacles.begin(), obstacles.end(), knows)) return;
  obstacles.emplace_back(plane, std::array{travellers[0].start.position, travellers[1].start.position},
                         std::array{travellers[0].goal.position, travellers[1].goal.position}, slice, budget);
}

std::vector<Obstacle> obstacles_on_way(const ForbiddenPlane& plane, const Travellers& travellers,
                                       const Budget& budget) {
  std::vector<Obstacle> obstacles;
  const Interval first = travellers[0].fastest.extent();
  const Interval second = travellers[1].fastest.extent();
  for (int i = 0; i < kSeedSlices && obstacles.size() < kMostObstacles; ++i) {
    const double position = first.lower + first.length() * i / (kSeedSlices - 1);
    for (const Interval& stretch : plane.slice(0, position).intervals()) {
      if (stretch.upper < second.lower || stretch.lower > second.upper) continue;
      if (budget.exhausted()) return obstacles;
      add_obstacle(obstacles, plane, travellers, {0, position, stretch}, budget);
    }
  }
  return obstacles;
}

/// The obstacles that known ways lead around.
std::vector<Obstacle> obstacles_at(const std::vector<Way>& ways, const ForbiddenPlane& plane,
                                   const Travellers& travellers, const Budget& budget) {
  std::vector<Obstacle> obstacles;
  for (const Way& way : ways) {
    const Gate& gate = way.gate;
    std::optional<Interval> nearest;
    const auto away = [&](const Interval& stretch) {
      return std::abs((gate.runs_up ? stretch.upper : stretch.lower) - gate.corner_position);
    };
    for (const Interval& stretch : plane.slice(gate.pinned_arm, gate.pinned_position).intervals()) {
      if (!nearest || away(stretch) < away(*nearest)) nearest = stretch;
    }
    if (nearest) add_obstacle(obstacles, plane, travellers, {gate.pinned_arm, gate.pinned_position, *nearest}, budget);
  }
  return obstacles;
}

/// The ways around one obstacle and the bound of the faster one.
PassageBound bound_of(const ForbiddenPlane& plane, const Travellers& travellers, Obstacle& obstacle,
                      const std::vector<Way>& near_by, const Budget& budget) {
  PassageBound bound = {kInfinity, {}, true};
  for (const int side : {0, 1}) {
    if (obstacle.is_closed(side)) continue;
    const auto way = slowest_gate(plane, travellers, obstacle, side, near_by, budget);
    bound.duration = std::min(bound.duration, way ? way->bound.duration : 0.0);
    if (way) bound.ways.push_back(*way);
  }
  std::stable_sort(bound.ways.begin(), bound.ways.end(),
                   [](const Way& a, const Way& b) { return a.bound.duration < b.bound.duration; });
  return bound;
}

}  // namespace

PassageBound passage_bound(const ForbiddenPlane& plane, const Travellers& travellers, const Budget& budget,
                           const std::vector<Way>& near_by) {
  PassageBound best;
  std::vector<Obstacle> obstacles = obstacles_at(near_by, plane, travellers, budget);
  if (obstacles.empty()) obstacles = obstacles_on_way(plane, travellers, budget);
  for (Obstacle& obstacle : obstacles) {
    if (budget.exhausted()) break;
    PassageBound bound = bound_of(plane, travellers, obstacle, near_by, budget);
    if (bound.duration > best.duration || best.ways.empty()) best = std::move(bound);
  }
  best.is_whole = !budget.exhausted();
  return best;
}

}  // namespace dualarm
